//! Many scenes, and what becomes of each.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::Duration;

use super::check::{Checked, Failure, Verdict};
use super::compared::Stage;
use super::generator;
use pounding_scene::{Scene, parallel};

/// Random scenes, each run by both routes.
#[derive(Debug, Clone)]
pub struct Campaign {
    /// Folder of the studies, from which scenes name records.
    pub studies: PathBuf,
    /// Seed of the scenes.
    pub seed: u64,
    /// Longest time that a part of the work on a scene may take: a guard for what would never end, no measure of work.
    pub patience: Duration,
}

impl Campaign {
    /// Scene number `index`; its record is named relative to the folder of the studies.
    pub fn scene(&self, index: usize) -> Scene {
        generator::scene(self.seed, index)
    }

    /// Runs scenes, in their order whatever the number of threads; `done` is called after each.
    pub fn run(&self, scenes: &[usize], done: &(dyn Fn(&Checked) + Sync)) -> Vec<Checked> {
        parallel::each(scenes, |&index| {
            let checked = self.check(index, &self.scene(index), &self.studies);
            done(&checked);
            checked
        })
    }

    /// Runs a scene, which need not be the campaign's, in a thread of its own, which is told to stop, and left behind, where it does not
    /// end; `base` is the folder from which it names its record.
    pub fn check(&self, index: usize, scene: &Scene, base: &Path) -> Checked {
        let (sender, receiver) = mpsc::channel();
        let (own, base) = (scene.clone(), base.to_path_buf());
        // A byte for each scene: whoever is left behind may look at it for as long as the program runs.
        let stop: &'static AtomicBool = Box::leak(Box::default());
        std::thread::spawn(move || {
            let begin = |stage| {
                // Nobody listens any more where patience has ended.
                sender.send(Message::Begins(stage)).ok();
            };
            let checked = Checked::run((index, &own), &base, (&begin, stop));
            sender.send(Message::Ends(Box::new(checked))).ok();
        });
        let mut stage = Stage::Exact;
        let verdict = loop {
            match receiver.recv_timeout(self.patience) {
                Ok(Message::Begins(next)) => stage = next,
                Ok(Message::Ends(checked)) => return *checked,
                Err(RecvTimeoutError::Timeout) => {
                    stop.store(true, Ordering::Relaxed);
                    break Verdict::Hangs;
                }
                Err(RecvTimeoutError::Disconnected) => break Verdict::Panics,
            }
        };
        let failure = Failure::new(stage.words().into(), String::new());
        Checked::new(index, scene, verdict, Some(failure))
    }
}

/// What a thread says of its work on a scene.
enum Message {
    Begins(Stage),
    Ends(Box<Checked>),
}
