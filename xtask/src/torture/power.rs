//! Power failures of an ext4 file system in a file. It is shut down at a random moment, by the ioctl of the kernel's tests, and mounted
//! again with the data on the disk.

use std::fs;
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;

use super::bench::{Bench, SWEEPS, TABLE, said, write_sweeps};

/// `EXT4_IOC_SHUTDOWN` without flushing the journal: data that was not synced is lost.
const SHUT_DOWN: &str = "import fcntl, os, struct, sys\n\
    disk = os.open(sys.argv[1], os.O_RDONLY)\n\
    print(flush=True)\n\
    sys.stdin.read()\n\
    fcntl.ioctl(disk, 0x8004587D, struct.pack('I', 2))";
/// Names reach the disk within a second, and unsynced contents of files much later: the worst order.
const OPTIONS: &str = "loop,commit=1,noauto_da_alloc";

/// Whether a program can be started.
pub(super) fn is_there(program: &str) -> bool {
    let mut asked = Command::new(program);
    asked.arg("--version").stdout(Stdio::null()).stderr(Stdio::null());
    asked.status().is_ok()
}

/// A separate file system.
struct Disk {
    image: PathBuf,
    place: PathBuf,
}

/// Some failures in the middle of a sweep, the others after its end.
pub(super) fn run(bench: &mut Bench, rounds: u32) -> Result<(), String> {
    let folder = bench.folder("power")?;
    let disk = Disk {
        image: folder.join("image"),
        place: folder.join("disk"),
    };
    if rounds == 0 {
        return Ok(());
    }
    if let Err(why) = disk.make().and_then(|()| disk.unmount()) {
        println!("Power failures are left out: {why}.");
        return Ok(());
    }
    let mut finished = 0;
    for round in 0..rounds {
        disk.make()?;
        let outcome = failure(bench, &disk, round % 2 == 0);
        let cut = disk.cut_off();
        let outcome = cut.and(outcome).and_then(|is_done| {
            finished += u32::from(is_done);
            if is_done && !bench.is_table_of(&disk.place, 0)? {
                return Err("a finished table is wrong".into());
            }
            bench.ends_well(&disk.place)
        });
        let unmounted = disk.unmount();
        outcome.map_err(|broken: String| format!("power failure {round}: {broken}"))?;
        unmounted?;
    }
    println!(
        "After {rounds} power failures, {finished} of them after exit code 0, no finished table was lost and each was right in the end."
    );
    Ok(())
}

/// Runs until the power fails; true if the program had ended with exit code 0 before.
fn failure(bench: &mut Bench, disk: &Disk, within: bool) -> Result<bool, String> {
    let arguments = ["sweep", SWEEPS[0], "--out", TABLE];
    let fail = |error: std::io::Error| format!("power failure: {error}");
    let switch = disk.switch()?;
    let mut child = bench.command(&disk.place, &arguments).spawn().map_err(fail)?;
    let wait = bench.time.mul_f64(1.2 * bench.random());
    if within {
        thread::sleep(wait);
        switch.turn()?;
        let ended = child.wait().map_err(fail)?;
        return Ok(ended.success());
    }
    let ended = child.wait().map_err(fail)?;
    thread::sleep(wait);
    switch.turn()?;
    if ended.success() {
        Ok(true)
    } else {
        Err("the sweep failed".into())
    }
}

/// A process that shuts the disk down as soon as no process writes to it.
struct Switch(Child);

impl Switch {
    fn turn(mut self) -> Result<(), String> {
        drop(self.0.stdin.take());
        match self.0.wait() {
            Ok(status) if status.success() => Ok(()),
            _ => Err("python3 cannot shut the disk down".into()),
        }
    }
}

impl Disk {
    /// An empty file system with the sweeps on it.
    fn make(&self) -> Result<(), String> {
        let file = fs::File::create(&self.image).map_err(|error| error.to_string())?;
        file.set_len(48 << 20).map_err(|error| error.to_string())?;
        drop(file);
        fs::create_dir_all(&self.place).map_err(|error| error.to_string())?;
        step(Command::new("mkfs.ext4").arg("-q").arg(&self.image))?;
        self.mount()?;
        write_sweeps(&self.place)?;
        step(Command::new("sync").arg("-f").arg(self.place.join(SWEEPS[0])))
    }

    fn mount(&self) -> Result<(), String> {
        step(Command::new("mount").args(["-o", OPTIONS]).args([&self.image, &self.place]))
    }

    fn unmount(&self) -> Result<(), String> {
        step(Command::new("umount").arg(&self.place))
    }

    /// Prepares the shutdown.
    fn switch(&self) -> Result<Switch, String> {
        let fail = |error: std::io::Error| format!("python3: {error}");
        let mut command = Command::new("python3");
        command.args(["-c", SHUT_DOWN]).arg(&self.place);
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut python = command.spawn().map_err(fail)?;
        // Its first line shows that it is ready.
        let mut ready = [0];
        let told = python.stdout.as_mut().map(|told| told.read_exact(&mut ready));
        told.transpose().map_err(fail)?;
        Ok(Switch(python))
    }

    /// Unmounts the disk and mounts it again.
    fn cut_off(&self) -> Result<(), String> {
        self.unmount()?;
        self.mount()
    }
}

fn step(command: &mut Command) -> Result<(), String> {
    let ended = command.output().map_err(|error| format!("{}: {error}", name(command)))?;
    if ended.status.success() {
        Ok(())
    } else {
        Err(format!("{}: {}", name(command), said(&ended)))
    }
}

fn name(command: &Command) -> String {
    Path::new(command.get_program()).display().to_string()
}
