//! Options of commands that answer about records: the form of the answer, and the folder of results.

use std::path::{Path, PathBuf};

use pounding::text::{Form, Refused};

use crate::folder::Out;

/// How the answer is printed.
#[derive(Debug, clap::Args)]
pub(super) struct Printed {
    /// Print more: every run, and every record that is left out.
    #[arg(long)]
    pub(super) details: bool,
    /// Print a table for a program, SI units.
    #[arg(long, conflicts_with_all = ["json", "details"])]
    csv: bool,
    /// Print JSON, SI units.
    #[arg(long)]
    json: bool,
}

impl Printed {
    pub(super) fn form(&self) -> Form {
        Form::asked(self.details, self.csv, self.json)
    }
}

/// Where a folder of results goes.
#[derive(Debug, clap::Args)]
pub(super) struct Results {
    /// Write a report with figures and tables here.
    #[arg(long, value_name = "FOLDER")]
    pub(super) out: Option<PathBuf>,
    /// Write into a folder that holds other things; they stay.
    #[arg(long, requires = "out")]
    overwrite: bool,
}

impl Results {
    /// Takes the folder, if one is asked for.
    pub(super) fn open(&self) -> Result<Option<Out>, Refused> {
        let open = |out: &PathBuf| Out::open(out, self.overwrite);
        self.out.as_ref().map(open).transpose()
    }

    /// Takes the folder as [`Self::open`] does, apart from folders of records and from other files that are read.
    pub(super) fn open_beside(&self, records: &[&Path], mut read: Vec<PathBuf>) -> Result<Option<Out>, Refused> {
        let out = self.open()?;
        if let Some(out) = &out {
            read.extend(records.iter().flat_map(|folder| super::inputs_in(folder)));
            out.keep(&read)?;
            records.iter().try_for_each(|folder| out.apart_from(folder))?;
        }
        Ok(out)
    }
}
