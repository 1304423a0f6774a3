//! Wall time of every method on the scenes of two structures; `cargo xtask bench` runs it and prints ratios.

use std::path::Path;
use std::time::Duration;

use criterion::Criterion;
use pounding_studies::Trade;

fn main() {
    let study = Path::new(env!("CARGO_MANIFEST_DIR")).join("../studies/trade.json");
    let (completed, trade) = Trade::of_two_structures(&study).expect("the study of the project runs");
    let mut criterion = Criterion::default().configure_from_args();
    for timed in trade.timed(&completed) {
        let mut group = criterion.benchmark_group(timed.scene);
        group
            .sample_size(20)
            .warm_up_time(Duration::from_millis(500))
            .measurement_time(Duration::from_secs(2));
        group.bench_function(timed.method, |bencher| {
            bencher.iter(|| timed.run().expect("it ran before"));
        });
        group.finish();
    }
    criterion.final_summary();
}
