//! The shard of a task of a job array, from the variables that the schedulers set.

use pounding::sweep::Shard;
use pounding::text::Refused;

/// The shard of this process with the variable that names its task; `None` if no variable does.
///
/// With a number of shards tasks count from 1: some of them can be submitted again. Task 0, of an array that counts from 0, has the last
/// shard. Without that number the array says how many tasks it has.
pub(super) fn shard(shards: Option<u64>, variable: impl Fn(&str) -> Option<String>) -> Result<Option<(&'static str, Shard)>, Refused> {
    let number = |name: &'static str| -> Result<Option<u64>, Refused> {
        let Some(text) = variable(name).filter(|text| !text.is_empty()) else {
            return Ok(None);
        };
        let refused = || Refused::at(name).found(format!("\"{text}\"")).allowed_is("a whole number >= 0");
        text.parse().map(Some).map_err(|_| refused())
    };
    let slurm = number("SLURM_ARRAY_TASK_ID")?;
    let task = match slurm {
        Some(task) => Some(("SLURM_ARRAY_TASK_ID", task)),
        None => number("HQ_TASK_ID")?.map(|task| ("HQ_TASK_ID", task)),
    };
    match (task, shards) {
        (None, None) => Ok(None),
        (None, Some(_)) => Err(Refused::at("--shards")
            .found("neither SLURM_ARRAY_TASK_ID nor HQ_TASK_ID")
            .allowed_is("it in a job array")
            .help("elsewhere say --shard I/N")),
        (Some((name, task)), Some(shards)) => {
            let index = if task == 0 { shards } else { task };
            Shard::new(index, shards).map(|shard| Some((name, shard))).map_err(|_| {
                let last = shards.saturating_sub(1);
                let found = Refused::at(name).found(task.to_string());
                let found = found.allowed_are(format!("1 to {shards} with --shards {shards}, or 0 to {last}"));
                found.help("change --shards or the array")
            })
        }
        (Some(("HQ_TASK_ID", _)), None) => {
            let task = Refused::at("HQ_TASK_ID").found("a task, but not how many there are");
            Err(task.help("add --shards N, or --shard 1/1 for the whole"))
        }
        (Some((name, task)), None) => {
            let count = number("SLURM_ARRAY_TASK_COUNT")?;
            let first = number("SLURM_ARRAY_TASK_MIN")?.unwrap_or(0);
            let step = number("SLURM_ARRAY_TASK_STEP")?.unwrap_or(1).max(1);
            let away = task.checked_sub(first).filter(|away| away % step == 0);
            let shard = count.zip(away).and_then(|(count, away)| Shard::new(away / step + 1, count).ok());
            shard.map(|shard| Some((name, shard))).ok_or_else(|| {
                let task = Refused::at("SLURM_ARRAY_TASK_ID").found("a task of an array without equal steps");
                task.help("number the tasks from 1 and add --shards N")
            })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::shard;

    fn found(shards: Option<u64>, set: &[(&str, &str)]) -> String {
        let variable = |name: &str| {
            let mut set = set.iter();
            let found = set.find(|(known, _)| *known == name);
            found.map(|(_, value)| (*value).to_string())
        };
        match shard(shards, variable) {
            Ok(Some((variable, shard))) => {
                assert!(set.iter().any(|(known, _)| *known == variable), "{variable}");
                shard.to_string()
            }
            Ok(None) => "the whole".into(),
            Err(refused) => refused.to_string(),
        }
    }

    #[test]
    fn reference_tasks_of_job_arrays() {
        let slurm = |id, count, min, step| {
            [
                ("SLURM_ARRAY_TASK_ID", id),
                ("SLURM_ARRAY_TASK_COUNT", count),
                ("SLURM_ARRAY_TASK_MIN", min),
                ("SLURM_ARRAY_TASK_STEP", step),
            ]
        };
        for (shards, set, wanted) in [
            (None, &[][..], "the whole"),
            (None, &slurm("0", "4", "0", "1"), "1/4"),
            (None, &slurm("3", "4", "0", "1"), "4/4"),
            (None, &slurm("8", "4", "1", "7"), "2/4"),
            (Some(8), &slurm("3", "2", "3", "4"), "3/8"),
            (Some(8), &[("HQ_TASK_ID", "8")], "8/8"),
            (Some(8), &[("HQ_TASK_ID", "0")], "8/8"),
        ] {
            assert_eq!(found(shards, set), wanted, "{set:?}");
        }
        for (shards, set, begins) in [
            (
                None,
                &slurm("5", "2", "3", "1")[..],
                "SLURM_ARRAY_TASK_ID: found a task of an array without",
            ),
            (None, &[("HQ_TASK_ID", "1")], "HQ_TASK_ID: found a task, but not how many"),
            (None, &[("SLURM_ARRAY_TASK_ID", "x")], "SLURM_ARRAY_TASK_ID: found \"x\""),
            (
                Some(4),
                &[("HQ_TASK_ID", "5")],
                "HQ_TASK_ID: found 5, allowed are 1 to 4 with --shards 4, or 0 to 3",
            ),
            (Some(4), &[], "--shards: found neither"),
        ] {
            let said = found(shards, set);
            assert!(said.starts_with(begins), "{said}");
        }
    }
}
