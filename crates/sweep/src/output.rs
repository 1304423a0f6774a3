//! The structures of a row, and the requested numbers: a column for each.

use pounding_scene::{FloorPair, FloorQuantity, Floors, Quantity, QuantityKind, Scene};

use super::file::Outputs;

/// Suffix of the names of a whole building, and of two neighbours.
const ANY_FLOOR: &str = " (any floor)";
const ANY_LEVEL: &str = " (any level)";

/// Whether a column belongs to a whole building or to two neighbours, by its name.
pub(super) fn is_of_all(column: &str) -> bool {
    let of = column.rsplit_once(": ").map_or(column, |(of, _)| of);
    of.ends_with(ANY_FLOOR) || of.ends_with(ANY_LEVEL)
}

/// The structures of a row. All runs of a sweep have equal ones, with the names of the first run.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct RowShape {
    structures: Vec<String>,
    floors: Vec<Named>,
    pairs: Vec<FloorPair>,
    /// Names of both sides of every pair.
    sides: Vec<[String; 2]>,
    /// Whether gravity acts on a leaning storey in some run, so that runs may end in a collapse.
    pub(super) leans: bool,
    /// Names of both ends of every link.
    links: Vec<[String; 2]>,
}

/// A floor, or a wall.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Named {
    name: String,
    /// Index of its structure.
    structure: usize,
    is_wall: bool,
    is_on_isolators: bool,
}

impl RowShape {
    pub(super) fn of(scene: &Scene, floors: &Floors) -> Self {
        let named = floors.all().iter().map(|floor| Named {
            name: floor.name.clone(),
            structure: floor.structure,
            is_wall: floor.is_wall(),
            is_on_isolators: floor.is_isolation_layer(),
        });
        Self {
            structures: floors.structures().to_vec(),
            floors: named.collect(),
            pairs: floors.facing().to_vec(),
            sides: floors.facing().iter().map(|pair| floors.names_of(pair)).collect(),
            leans: floors.has_gravity(),
            links: scene.links.iter().map(|link| link.names(scene)).collect(),
        }
    }

    pub(super) fn n_floors(&self) -> usize {
        self.floors.len()
    }

    /// Whether structures have equal numbers of floors, neighbours equal numbers of pairs, and rows equal numbers of links. Slabs that hit
    /// columns hit the same ones.
    pub(super) fn fits(&self, scene: &Scene, floors: &Floors) -> bool {
        let structures = self.floors.iter().map(|floor| floor.structure);
        let of_pairs = self.pairs.iter().map(|pair| self.neighbours(pair));
        let other = |floor: usize| floors.all()[floor].structure;
        let of_others = floors.facing().iter().map(|pair| [other(pair.left), other(pair.right)]);
        let columns = |pairs: &[FloorPair]| pairs.iter().copied().filter(|pair| pair.column.is_some()).collect::<Vec<_>>();
        let same_columns = columns(&self.pairs) == columns(floors.facing());
        let same_links = self.links.len() == scene.links.len();
        structures.eq(floors.all().iter().map(|floor| floor.structure)) && of_pairs.eq(of_others) && same_columns && same_links
    }

    /// Contacts across which floors can touch, from the left: those of the columns of `neighbours`.
    pub(super) fn contacts(&self) -> Vec<usize> {
        let mut all: Vec<usize> = self.pairs.iter().map(|pair| pair.contact).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// Left and right structure of a pair.
    fn neighbours(&self, pair: &FloorPair) -> [usize; 2] {
        [pair.left, pair.right].map(|floor| self.floors[floor].structure)
    }

    /// Numbers of floors of every structure, and numbers of pairs and links, in words.
    pub(super) fn words(&self) -> String {
        let of_structure = |index: usize| {
            let own = self.floors.iter().filter(|one| one.structure == index);
            own.count().to_string()
        };
        let floors: Vec<_> = (0..self.structures.len()).map(of_structure).collect();
        let links = match self.links.len() {
            0 => String::new(),
            n => format!(" and {n} links"),
        };
        format!("{} floors and walls and {} pairs{links}", floors.join(" + "), self.pairs.len())
    }

    /// The columns of the requested numbers.
    pub(super) fn outputs(&self, asked: &Outputs) -> Vec<Output> {
        let floors: Vec<_> = self.floors.iter().map(|one| one.name.clone()).collect();
        let each = |names: &[String]| {
            let names = unique(names).into_iter().enumerate();
            names.map(|(place, name)| (name, vec![place])).collect::<Vec<_>>()
        };
        let between = |[left, right]: [&String; 2]| format!("{left} - {right}");
        let joined = |sides: &[[String; 2]]| sides.iter().map(|[left, right]| between([left, right])).collect::<Vec<_>>();
        let (pairs, links) = (joined(&self.sides), joined(&self.links));
        let names = unique(&self.structures);
        let buildings = (0..names.len()).map(|structure| {
            let own = |place: &usize| self.floors[*place].structure == structure && !self.floors[*place].is_wall;
            let own = (0..floors.len()).filter(own).collect();
            (format!("{}{ANY_FLOOR}", names[structure]), own)
        });
        let mut two: Vec<_> = self.pairs.iter().map(|pair| self.neighbours(pair)).collect();
        two.sort_unstable();
        two.dedup();
        let neighbours = two.into_iter().map(|two| {
            let own = |place: &usize| self.neighbours(&self.pairs[*place]) == two;
            let name = between(two.map(|structure| &names[structure]));
            let own = (0..pairs.len()).filter(own).collect();
            (format!("{name}{ANY_LEVEL}"), own)
        });
        let mut buildings = columns(buildings, &asked.buildings, true);
        for of_storeys in buildings.iter_mut().filter(|one| is_of_storeys(one.quantity)) {
            // Isolators move by parts of their height that no storey bears.
            let storeys = of_storeys
                .places
                .iter()
                .copied()
                .filter(|place| !self.floors[*place].is_on_isolators);
            let storeys: Vec<usize> = storeys.collect();
            if !storeys.is_empty() {
                of_storeys.places = storeys;
            }
        }
        [
            buildings,
            columns(neighbours, &asked.neighbours, true),
            columns(each(&floors), &asked.structures, false),
            columns(each(&pairs), &asked.pairs, false),
            columns(each(&links), &asked.links, false),
            self.collapses(),
        ]
        .concat()
    }
}

impl RowShape {
    /// The column of the instant at which a run ends in a collapse, by which summaries count these runs; empty without gravity.
    fn collapses(&self) -> Vec<Output> {
        let moving = (0..self.floors.len()).filter(|floor| !self.floors[*floor].is_wall);
        let quantity = COLLAPSE.into();
        let column = self.leans.then(|| Output {
            name: collapse_column().into(),
            quantity,
            places: moving.collect(),
            is_whole: false,
        });
        column.into_iter().collect()
    }
}

/// The number by which summaries count runs that end in a collapse.
const COLLAPSE: FloorQuantity = FloorQuantity::CollapseS;

/// Name of its column, which belongs to the whole row.
pub(super) fn collapse_column() -> &'static str {
    COLLAPSE.about().name
}

/// Whether a quantity compares a storey with what storeys bear, which isolators do not enter.
fn is_of_storeys(quantity: Quantity) -> bool {
    [FloorQuantity::DriftRatio, FloorQuantity::Ductility]
        .into_iter()
        .any(|one| quantity == one.into())
}

/// All quantities of each of these places; empty without places.
fn columns<Q: Into<Quantity> + Copy>(of: impl IntoIterator<Item = (String, Vec<usize>)>, quantities: &[Q], is_whole: bool) -> Vec<Output> {
    let of = of.into_iter().filter(|(_, places)| !places.is_empty());
    let columns = of.flat_map(|(name, places)| {
        quantities.iter().map(move |quantity| {
            let quantity = (*quantity).into();
            Output {
                name: format!("{name}: {}", quantity.about().name),
                quantity,
                places: places.clone(),
                is_whole,
            }
        })
    });
    columns.collect()
}

/// A requested number of every run: a column.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Output {
    /// Name of its column.
    pub(super) name: String,
    pub(super) quantity: Quantity,
    /// Floors or pairs among which the severest counts; at least one.
    places: Vec<usize>,
    /// Whether these are all floors or pairs.
    is_whole: bool,
}

impl Output {
    /// The quantity of a place. For a whole building, the drift of the storey on the ground is its displacement.
    pub(super) fn asked_of(&self, floors: &Floors, place: usize) -> Quantity {
        match self.quantity {
            Quantity::Floor(_) if self.is_whole => self.quantity.of_storey(floors.all()[place].is_upper()),
            Quantity::Floor(_) | Quantity::Pair(_) | Quantity::Link(_) => self.quantity,
        }
    }

    /// The number of the severest place, and its least scale, from those of each place; NaN if no place has one.
    pub(super) fn severest(&self, of: impl Fn(usize) -> (f64, f64)) -> (f64, f64) {
        let is_severe_if_small = matches!(self.quantity.about().kind, QuantityKind::Least | QuantityKind::First);
        let severity = |number: f64| if is_severe_if_small { -number } else { number.abs() };
        let mut places = self.places.iter().map(|place| of(*place));
        let first = places.next().unwrap_or((f64::NAN, 0.0));
        places.fold(first, |found, other| {
            let is_severer = severity(other.0) > severity(found.0);
            if is_severer || found.0.is_nan() { other } else { found }
        })
    }
}

/// Names with numbers added to duplicates.
fn unique(names: &[String]) -> Vec<String> {
    let same = |index: usize| names.iter().filter(move |name| **name == names[index]);
    let own = |index: usize| {
        let before = names[..index].iter().filter(|name| **name == names[index]);
        match same(index).count() {
            1 => names[index].clone(),
            _ => format!("{} ({})", names[index], before.count() + 1),
        }
    };
    (0..names.len()).map(own).collect()
}
