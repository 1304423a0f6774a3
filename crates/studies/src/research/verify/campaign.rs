//! Campaigns: many random scenes with a verdict on each.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::Duration;

use super::check::{Checked, Failure, Verdict};
use super::compared::Stage;
use super::generator;
use pounding_scene::{Scene, parallel};

/// Random scenes that run by both routes.
#[derive(Debug, Clone)]
pub struct Campaign {
    /// Folder of the studies; records in the scenes are named relative to it.
    pub studies: PathBuf,
    /// Seed of the scenes.
    pub seed: u64,
    /// Longest time for one part of the work on a scene. It guards against runs without end and is not a measure of work.
    pub patience: Duration,
}

impl Campaign {
    /// Scene number `index`. The name of its record is relative to the folder of the studies.
    pub fn scene(&self, index: usize) -> Scene {
        generator::scene(self.seed, index)
    }

    /// Runs scenes in parallel; the results have the order of the scenes. Calls `done` after each scene.
    pub fn run(&self, scenes: &[usize], done: &(dyn Fn(&Checked) + Sync)) -> Vec<Checked> {
        parallel::each(scenes, |&index| {
            let checked = self.check(index, &self.scene(index), &self.studies);
            done(&checked);
            checked
        })
    }

    /// Runs any scene in a separate thread. If the thread does not finish in time, it is told to stop and is abandoned. `base` is the
    /// folder that the name of the record is relative to.
    pub fn check(&self, index: usize, scene: &Scene, base: &Path) -> Checked {
        let (sender, receiver) = mpsc::channel();
        let (own, base) = (scene.clone(), base.to_path_buf());
        // The flag is leaked, one byte per scene: an abandoned thread may read it for as long as the program runs.
        let stop: &'static AtomicBool = Box::leak(Box::default());
        std::thread::spawn(move || {
            let begin = |stage| {
                // Sending fails if the patience has ended and nobody receives any more; the failure is ignored.
                sender.send(Message::Begins(stage)).ok();
            };
            let checked = Checked::run(index, &own, &base, &begin, stop);
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

/// A message of a thread about its work on a scene.
enum Message {
    Begins(Stage),
    Ends(Box<Checked>),
}
