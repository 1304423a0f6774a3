//! Timing, and writing of tables.

use std::error::Error;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use fearless_simd::prelude::*;
use fearless_simd::{Level, dispatch};

/// Result of a benchmark, or its error.
pub(crate) type Outcome<T> = Result<T, Box<dyn Error>>;

/// Rounds of a timing: they continue until both limits are reached.
#[derive(Clone, Copy)]
pub(crate) struct Rounds {
    /// Least number of rounds.
    least: usize,
    /// Least duration of all rounds.
    patience: Duration,
}

impl Rounds {
    pub(crate) const fn new(least: usize, seconds: u64) -> Self {
        Self {
            least,
            patience: Duration::from_secs(seconds),
        }
    }
}

/// Wall times of runs \[s\], a list for each number in the order.
///
/// A round runs the whole order, every second round backwards, so that other load of the machine affects all runs.
pub(crate) fn in_turn(order: &[usize], rounds: Rounds, mut run: impl FnMut(usize) -> Outcome<()>) -> Outcome<Vec<Vec<f64>>> {
    let mut times = vec![Vec::new(); order.iter().max().map_or(0, |last| last + 1)];
    let mut order = order.to_vec();
    let (started, mut done) = (Instant::now(), 0);
    while done < rounds.least || started.elapsed() < rounds.patience {
        for one in &order {
            let start = Instant::now();
            run(*one)?;
            times[*one].push(start.elapsed().as_secs_f64());
        }
        order.reverse();
        done += 1;
    }
    Ok(times)
}

/// The median; the upper one of two, NaN of none.
pub(crate) fn median(values: impl IntoIterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// The median ratio of times from common rounds.
pub(crate) fn ratio(times: &[f64], others: &[f64]) -> f64 {
    median(times.iter().zip(others).map(|(time, other)| time / other))
}

/// A table of ratios.
pub(crate) struct RatioTable {
    /// Path of the file, from the top folder.
    pub(crate) path: &'static str,
    /// Title for the terminal.
    pub(crate) title: &'static str,
    pub(crate) header: &'static str,
}

impl RatioTable {
    /// Writes and prints lines. If the table begins with the instructions of the machine, each line gets them and replaces lines with these
    /// instructions; lines of other machines stay.
    pub(crate) fn write(&self, root: &Path, lines: &[String]) -> Outcome<()> {
        let Self { path, title, header } = self;
        let before = fs::read_to_string(root.join(path)).unwrap_or_default();
        let by_machine = header.starts_with("instructions,");
        let own = if by_machine {
            format!("{},", instructions())
        } else {
            String::new()
        };
        let others = before.lines().skip(1);
        let others = others.filter(|line| by_machine && !line.starts_with(&own));
        let lines = lines.iter().map(|line| format!("{own}{line}"));
        let all = others.map(str::to_owned).chain(lines);
        let csv = all.fold(format!("{header}\n"), |csv, line| csv + &line + "\n");
        keep(root, path, csv.as_bytes())?;
        println!("\n{title}:\n{csv}\nkept in {path}");
        Ok(())
    }
}

/// The widest vector instructions of this machine that tables distinguish.
fn instructions() -> &'static str {
    fn lanes<S: Simd>(_: S) -> usize {
        <S::f64s as SimdBase<S>>::LEN
    }
    match dispatch!(Level::new(), simd => lanes(simd)) {
        8 => "AVX-512",
        4 => "AVX2",
        _ => "others",
    }
}

/// Writes a file of results, from the top folder.
pub(crate) fn keep(root: &Path, path: &str, bytes: &[u8]) -> Outcome<()> {
    let place = root.join(path);
    fs::create_dir_all(place.parent().unwrap_or(root))
        .and_then(|()| fs::write(&place, bytes))
        .map_err(|error| format!("{path}: {error}").into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_runs_take_turns_there_and_back() {
        let mut seen = Vec::new();
        let times = in_turn(&[0, 1, 1], Rounds::new(2, 0), |one| {
            seen.push(one);
            Ok(())
        });
        assert_eq!(seen, [0, 1, 1, 1, 1, 0]);
        let lengths: Vec<usize> = times.unwrap().iter().map(Vec::len).collect();
        assert_eq!(lengths, [2, 4]);
    }

    #[test]
    fn limit_lines_of_other_machines_stay() {
        let root = std::env::temp_dir().join(format!("pounding-bench-{}", std::process::id()));
        let table = RatioTable {
            path: "a/table.csv",
            title: "A table",
            header: "instructions,time",
        };
        keep(&root, table.path, b"instructions,time\nnone,1\n").unwrap();
        for time in ["2", "3"] {
            table.write(&root, &[time.into()]).unwrap();
        }
        let text = fs::read_to_string(root.join(table.path)).unwrap();
        let own = instructions();
        fs::remove_dir_all(root).unwrap();
        assert_eq!(text, format!("instructions,time\nnone,1\n{own},3\n"));
    }
}
