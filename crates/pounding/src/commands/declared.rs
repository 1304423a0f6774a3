//! Options that declare what record files leave out.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use pounding::assess::{FolderUse, SelectionFactors};
use pounding::motion::AccelerationUnit;
use pounding::scene::file::Unit;
use pounding::scene::{FileUse, Scene};
use pounding::text::Naming;
use serde_json::json;

use super::positive;

/// Help of `--unit`.
const UNITS: &str = "One of g, mg, g_per_10, m_per_s2, cm_per_s2, mm_per_s2";

/// Declarations for files that leave them out; the fields of `record` in a scene.
#[derive(Debug, Clone, Default, PartialEq, clap::Args)]
#[command(next_help_heading = "What a file does not say")]
#[expect(clippy::struct_excessive_bools, reason = "each is an option of the program")]
pub(super) struct Declared {
    /// Unit of the values.
    #[arg(long, value_name = "UNIT", help = UNITS, value_parser = unit(), hide_possible_values = true)]
    unit: Option<Unit>,
    /// Time between samples [s].
    #[arg(long, value_name = "DT", allow_negative_numbers = true, value_parser = positive)]
    time_step: Option<f64>,
    /// What one count of a digitiser is worth, in --unit.
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    per_count: Option<f64>,
    /// Accelerations, though the file suggests otherwise.
    #[arg(long)]
    acceleration: bool,
    /// Several numbers to a line are consecutive values.
    #[arg(long)]
    in_rows: bool,
    /// Shake along this axis, from two horizontal components [° from north].
    #[arg(long, value_name = "DEG", allow_negative_numbers = true, value_parser = axis)]
    axis: Option<f64>,
    /// Read folders within a folder, too.
    #[arg(long)]
    sub_folders: bool,
    /// Multiply by the scale factors of PEER's _SearchResults.csv.
    #[arg(long)]
    pub(super) selection_factors: bool,
}

/// An azimuth.
fn axis(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(axis) if axis.abs() <= 360.0 => Ok(axis),
        _ => Err("allowed is an angle from -360 to 360".into()),
    }
}

/// The units by the names that scenes give them.
fn unit() -> impl TypedValueParser<Value = Unit> {
    let names = AccelerationUnit::ALL.map(AccelerationUnit::name);
    PossibleValuesParser::new(names).map(|name| serde_json::from_value(json!(name)).expect("scenes know every unit"))
}

impl Declared {
    /// Returns the declarations of the command line, and `of_scene` where it has none.
    pub(super) fn over(&self, of_scene: FileUse) -> FileUse {
        FileUse {
            unit: self.unit.or(of_scene.unit),
            time_step_s: self.time_step.or(of_scene.time_step_s),
            per_count: self.per_count.or(of_scene.per_count),
            acceleration: self.acceleration || of_scene.acceleration,
            in_rows: self.in_rows || of_scene.in_rows,
            axis_deg: self.axis.or(of_scene.axis_deg),
            naming: Naming::Option,
            ..of_scene
        }
    }

    /// Returns how a folder is read whose files shake a scene: by the command line, else as the scene declares its record.
    pub(super) fn of_files(&self, scene: &Scene) -> FolderUse {
        self.of_folder(self.over(scene.record.declared()))
    }

    /// Returns how a folder is read with these declarations.
    pub(super) fn of_folder(&self, declared: FileUse) -> FolderUse {
        FolderUse {
            declared,
            sub_folders: self.sub_folders,
            selection_factors: if self.selection_factors {
                SelectionFactors::Used
            } else {
                SelectionFactors::LeftOut
            },
        }
    }
}
