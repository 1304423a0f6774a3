//! States of a row: what a motion may do to it that is counted.

use std::str::FromStr;

use pounding_text::{Refused, digits};

/// Numbers of one run.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RunNumbers {
    /// Width that every gap needs \[m\], from the left: neighbours touch in a narrower gap.
    pub required: Vec<f64>,
    /// Largest drift of a storey over its height \[–\]; `None` if it was not asked for.
    pub drift: Option<f64>,
    /// Largest force between neighbours \[N\], 0 if none touch; `None` if it was not asked for.
    pub force: Option<f64>,
    /// Largest shear force of the columns of a storey \[N\]; `None` if it was not asked for.
    pub shear: Option<f64>,
    /// Whether a storey collapses under gravity, which ends the run: the other numbers are those until then.
    pub collapsed: bool,
}

impl RunNumbers {
    /// The numbers of a proportional row under this part of the motion, of which only widths were asked for.
    #[must_use]
    pub fn of_part(mut self, share: f64) -> Self {
        for required in &mut self.required {
            *required *= share;
        }
        self
    }
}

/// A state that a motion reaches or not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum State {
    /// Neighbours touch: across any gap, or across the gap of this number, from 0 at the left, while the others stay open.
    Touch(Option<usize>),
    /// The drift of some storey exceeds this part of its height \[–\].
    Drift(f64),
    /// The force between some neighbours exceeds this \[N\].
    Force(f64),
    /// The shear force of the columns of some storey exceeds this \[N\].
    Shear(f64),
    /// A storey collapses under gravity.
    Collapse,
}

impl State {
    /// Whether a run reaches the state; gaps are those of the row \[m\]. `None` if the run lacks the number. A run that collapses reaches every
    /// state: what would come after is worse, and shares that end below 1 would flatten the fragility where nothing collapses.
    pub fn is_reached(self, numbers: &RunNumbers, gaps: &[f64]) -> Option<bool> {
        if numbers.collapsed {
            return Some(true);
        }
        match self {
            Self::Touch(gap) => {
                let mut both = numbers.required.iter().zip(gaps).enumerate();
                let counts = |index: usize| gap.is_none_or(|gap| gap == index);
                (!numbers.required.is_empty()).then(|| both.any(|(index, (required, gap))| counts(index) && required > gap))
            }
            Self::Drift(limit) | Self::Force(limit) | Self::Shear(limit) => Some(self.demand(numbers)? > limit),
            Self::Collapse => Some(numbers.collapsed),
        }
    }

    /// The number that the state limits: of touching the width that the gap needs \[m\], the largest of several. `None` of a collapse.
    pub fn demand(self, numbers: &RunNumbers) -> Option<f64> {
        match self {
            Self::Touch(Some(gap)) => numbers.required.get(gap).copied(),
            Self::Touch(None) => numbers.required.iter().copied().reduce(f64::max),
            Self::Drift(_) => numbers.drift,
            // Neighbours that do not touch have no force.
            Self::Force(_) => numbers.force,
            Self::Shear(_) => numbers.shear,
            Self::Collapse => None,
        }
    }

    /// Limit of the demand, of touching the gap among these \[m\]; `None` of a collapse, and of several gaps.
    pub fn limit(self, gaps: &[f64]) -> Option<f64> {
        match self {
            Self::Touch(Some(gap)) => gaps.get(gap).copied(),
            Self::Touch(None) => (gaps.len() == 1).then(|| gaps[0]),
            Self::Drift(limit) | Self::Force(limit) | Self::Shear(limit) => Some(limit),
            Self::Collapse => None,
        }
    }

    /// The verb of a sentence about motions that reach the state, as in "the motions touch".
    pub fn words(self) -> String {
        match self {
            Self::Touch(None) => "touch".into(),
            Self::Touch(Some(gap)) => format!("close gap {}", gap + 1),
            Self::Drift(limit) => format!("exceed a drift of {} %", digits(100.0 * limit)),
            Self::Force(limit) => format!("exceed a force of {} kN", digits(limit * 1e-3)),
            Self::Shear(limit) => format!("exceed a shear force of {} kN", digits(limit * 1e-3)),
            Self::Collapse => "collapse".into(),
        }
    }

    /// Name for people.
    pub fn shown(self) -> String {
        match self {
            Self::Touch(None) | Self::Collapse => self.name(),
            Self::Touch(Some(gap)) => format!("touch, gap {}", gap + 1),
            Self::Drift(limit) => format!("drift > {} %", digits(100.0 * limit)),
            Self::Force(limit) => format!("force > {} kN", digits(limit * 1e-3)),
            Self::Shear(limit) => format!("shear > {} kN", digits(limit * 1e-3)),
        }
    }

    /// Name for programs and for options.
    pub fn name(self) -> String {
        match self {
            Self::Touch(None) => "touch".into(),
            Self::Touch(Some(gap)) => format!("touch={}", gap + 1),
            Self::Drift(limit) => format!("drift={}", digits(limit)),
            Self::Force(limit) => format!("force={}", digits(limit)),
            Self::Shear(limit) => format!("shear={}", digits(limit)),
            Self::Collapse => "collapse".into(),
        }
    }
}

impl FromStr for State {
    type Err = Refused;

    fn from_str(text: &str) -> Result<Self, Refused> {
        let refused = || {
            let found = Refused::default().found(format!("\"{text}\""));
            found.allowed_are("touch, touch=2 (the second gap from the left), drift=0.01, force=5e6 (N), shear=5e6 (N) and collapse")
        };
        let (name, number) = match text.trim().split_once('=') {
            Some((name, number)) => (name, Some(number)),
            None => (text.trim(), None),
        };
        let limit = || {
            let limit = number.and_then(|number| number.trim().parse::<f64>().ok());
            limit.filter(|limit| *limit > 0.0 && limit.is_finite()).ok_or_else(refused)
        };
        match (name, number) {
            ("touch", None) => Ok(Self::Touch(None)),
            ("touch", Some(gap)) => match gap.trim().parse::<usize>() {
                Ok(gap) if gap > 0 => Ok(Self::Touch(Some(gap - 1))),
                _ => Err(refused()),
            },
            ("drift", _) => limit().map(Self::Drift),
            ("force", _) => limit().map(Self::Force),
            ("shear", _) => limit().map(Self::Shear),
            ("collapse", None) => Ok(Self::Collapse),
            _ => Err(refused()),
        }
    }
}
