//! Event and station of a record file, by its header.

/// Facts that a header says; `None` if it does not.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct HeaderFacts {
    /// Name of the event.
    pub event: Option<String>,
    /// Code or name of the station.
    pub station: Option<String>,
    /// Distance of the station from the epicentre \[m\].
    pub epicentral_distance: Option<f64>,
    /// Mean velocity of shear waves in the upper 30 m of the ground \[m/s\].
    pub vs30: Option<f64>,
}

/// Words with which a line about each begins: ESM and AFAD, K-NET, SMC, CSMIP, `GeoNet`.
const EVENT: &[&str] = &["EVENT_NAME"];
const STATION: &[&str] = &["STATION_CODE", "Station Code", "station =", "Station No.", "Statn No", "Site "];
const DISTANCE: &[&str] = &["EPICENTRAL_DISTANCE_KM", "epicentral dist ="];
const VS30: &[&str] = &["VS30_M/S"];

impl HeaderFacts {
    /// Takes the facts from the lines of a header, as [`Accelerogram::provenance`](pounding_motion::Accelerogram::provenance) has them.
    pub fn of(header: &str) -> Self {
        let said = |words: &[&str]| header.lines().find_map(|line| words.iter().find_map(|begin| after(line, begin)));
        let number = |words: &[&str]| said(words)?.split_whitespace().next()?.parse::<f64>().ok().filter(|one| *one > 0.0);
        let [event, station] = header.lines().find_map(of_peer).map_or([None, None], |both| both.map(Some));
        let owned = |text: &str| text.to_owned();
        Self {
            event: event.or_else(|| said(EVENT)).map(owned),
            station: station.or_else(|| said(STATION)).map(owned),
            epicentral_distance: number(DISTANCE).map(|kilometres| 1e3 * kilometres),
            vs30: number(VS30),
        }
    }
}

/// The text behind the first words of a line, until two blanks; `None` if the line begins otherwise.
fn after<'a>(line: &'a str, begin: &str) -> Option<&'a str> {
    let head = line.get(..begin.len())?;
    let rest = line[begin.len()..].trim_start_matches([' ', ':', '=']);
    let text = rest.split("  ").next()?.trim();
    (head.eq_ignore_ascii_case(begin) && !text.is_empty()).then_some(text)
}

/// Event and station of PEER's line, as in `Imperial Valley-02, 5/19/1940, El Centro Array #9, 180`.
fn of_peer(line: &str) -> Option<[&str; 2]> {
    let fields: Vec<&str> = line.split(',').map(str::trim).collect();
    let [event, date, station, _, ..] = fields[..] else {
        return None;
    };
    let is_date = date.split('/').count() == 3 && date.chars().all(|letter| letter == '/' || letter.is_ascii_digit());
    (is_date && !event.is_empty() && !station.is_empty()).then_some([event, station])
}

#[cfg(test)]
mod tests {
    use super::HeaderFacts;

    /// The layouts as agencies write them.
    #[test]
    fn reference_headers_of_agencies() {
        let facts = |event: Option<&str>, station: Option<&str>, epicentral_distance, vs30| HeaderFacts {
            event: event.map(String::from),
            station: station.map(String::from),
            epicentral_distance,
            vs30,
        };
        let esm = "EVENT_NAME: SOMEWHERE NORTH\nEVENT_ID: 7\nSTATION_CODE: ZZZ1\nEPICENTRAL_DISTANCE_KM: 88.1\nVS30_M/S: 310";
        assert_eq!(
            HeaderFacts::of(esm),
            facts(Some("SOMEWHERE NORTH"), Some("ZZZ1"), Some(88.1e3), Some(310.0))
        );
        let unknown = "EVENT_NAME:\nSTATION_CODE: ZZZ1\nEPICENTRAL_DISTANCE_KM: \nVS30_M/S: ";
        assert_eq!(HeaderFacts::of(unknown), facts(None, Some("ZZZ1"), None, None));
        let smc = "station = A Town, a school        component=     27\nepicentral dist =     12.0       pk     =     71.8";
        assert_eq!(HeaderFacts::of(smc), facts(None, Some("A Town, a school"), Some(12e3), None));
        let knet = "Origin Time       2001/02/03 04:05:00\nStation Code      ZZZ001\nStation Lat.      10.0";
        assert_eq!(HeaderFacts::of(knet), facts(None, Some("ZZZ001"), None, None));
        let csmip = "Somewhere Earthquake\nStation No. 99999   10.000N, 20.000W     ABC-1  s/n 1";
        assert_eq!(HeaderFacts::of(csmip), facts(None, Some("99999"), None, None));
        let peer =
            "PEER NGA STRONG MOTION DATABASE RECORD\nSomewhere-02, 5/19/1940, A Town Array #9, 180\nACCELERATION TIME SERIES IN UNITS OF G";
        assert_eq!(
            HeaderFacts::of(peer),
            facts(Some("Somewhere-02"), Some("A Town Array #9"), None, None)
        );
        assert_eq!(HeaderFacts::of(""), HeaderFacts::default());
    }
}
