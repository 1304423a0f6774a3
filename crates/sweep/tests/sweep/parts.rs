//! Parts of a table: how it is cut changes no byte of it.

use std::fs;

use pounding_sweep::{Parts, Shard, merge};
use serde_json::{Value, json};

use crate::{GO, folder, scene, sweep};

/// A table that another version had begun to cut otherwise goes on with its parts, and has the same bytes.
#[test]
fn limit_a_table_cut_otherwise_has_the_same_bytes() {
    let folder = folder("cut");
    let words = json!({
        "scene": scene(),
        "vary": [{"field": "contacts[0].gap_m", "uniform": {"from": 0.0, "to": 0.02}}],
        "samples": {"count": 50, "seed": 4, "method": "sobol"},
    });
    let sweep = sweep(&folder, &words);
    let mut tables = Vec::new();
    for (name, cut) in [("usual.csv", None), ("other.csv", Some(7))] {
        let out = folder.join(name);
        let parts = Parts::open(&sweep, &out, false).expect("parts");
        if let Some(runs) = cut {
            let path = parts.folder().join("manifest.json");
            let text = fs::read_to_string(&path).expect("a manifest");
            let mut manifest: Value = serde_json::from_str(&text).expect("JSON");
            manifest["runs_per_part"] = json!(runs);
            fs::write(&path, manifest.to_string()).expect("a disk");
        }
        for shard in [Shard::new(2, 2).expect("a shard"), Shard::WHOLE] {
            let parts = Parts::open(&sweep, &out, false).expect("they go on");
            parts.fill(&sweep, shard, &GO, &|_| ()).expect("a disk");
            assert_eq!(parts.runs_there(shard), parts.runs_of(shard));
        }
        let first = parts.folder().join("part-000000000.csv");
        let lines = fs::read_to_string(&first).expect("a part").lines().count();
        assert_eq!(lines, cut.unwrap_or(1), "{name}");
        let joined = merge(&out, &[parts.folder().to_path_buf()]).expect("a table");
        assert_eq!((joined.runs, joined.failed), (50, 0));
        tables.push(fs::read(&out).expect("a table"));
    }
    assert!(tables[0] == tables[1], "cuts change bytes");
}
