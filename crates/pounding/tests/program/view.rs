//! Tests of `pounding view`: what its server answers, and what it refuses.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::Duration;

use serde_json::{Value, json};

use crate::{folder, good_scene, pounding, quiet};

/// The program while it serves its page; it ends with the test.
struct Serving {
    program: Child,
    host: String,
    token: String,
}

impl Drop for Serving {
    fn drop(&mut self) {
        let _ = self.program.kill();
        let _ = self.program.wait();
    }
}

impl Serving {
    fn of(folder: &Path, arguments: &[&str]) -> Self {
        let mut program = Command::new(assert_cmd::cargo::cargo_bin!("pounding"))
            .args([&["view", "--no-open"], arguments].concat())
            .current_dir(folder)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("the program starts");
        let mut line = String::new();
        let printed = program.stdout.take().expect("its output is read");
        BufReader::new(printed).read_line(&mut line).expect("an address");
        let (host, token) = line
            .trim()
            .strip_prefix("http://")
            .and_then(|rest| rest.split_once("/#token="))
            .expect("an address with a token");
        Self {
            host: host.into(),
            token: token.into(),
            program,
        }
    }

    /// Sends bytes and returns status and body of the answer. A server that refuses may close before all is sent.
    fn sent(&self, bytes: &[u8]) -> (u16, String) {
        let mut stream = TcpStream::connect(&self.host).expect("the server listens");
        stream.set_read_timeout(Some(Duration::from_secs(60))).expect("a socket");
        let _ = stream.write_all(bytes);
        let mut answer = Vec::new();
        let _ = stream.read_to_end(&mut answer);
        let answer = String::from_utf8_lossy(&answer).into_owned();
        let status = answer.split(' ').nth(1).and_then(|status| status.parse().ok());
        let (_, body) = answer.split_once("\r\n\r\n").unwrap_or_default();
        (status.unwrap_or(0), body.into())
    }

    /// Status of a request with these lines of the head.
    fn status(&self, lines: &[&str], body: &str) -> u16 {
        self.sent(format!("{}\r\n\r\n{body}", lines.join("\r\n")).as_bytes()).0
    }

    /// Sends a call as the page does.
    fn call(&self, name: &str, window: u64, guide: &str, knobs: &Value) -> (u16, String) {
        self.called(
            name,
            json!({"window": window, "guide": guide, "knobs": knobs}).to_string().as_bytes(),
        )
    }

    /// Sends a call with the name or the key of a dropped record, and the record.
    fn under(&self, record: &str, name: &str, bytes: &[u8]) -> (u16, String) {
        let call = json!({"window": 1, "guide": "", "knobs": {}, "record": record}).to_string();
        self.called(name, &[call.as_bytes(), bytes].join(&b'\n'))
    }

    fn called(&self, name: &str, body: &[u8]) -> (u16, String) {
        let head = format!(
            "POST /api/{name} HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}\r\nX-Pounding-Token: {}\r\nContent-Length: {}\r\n\r\n",
            self.token,
            body.len(),
            host = self.host,
        );
        self.sent(&[head.as_bytes(), body].concat())
    }

    /// The sentence of a guide, and a run.
    fn run(&self, guide: &str, knobs: &Value) -> (Value, Value) {
        let (status, body) = self.call("run", 1, guide, knobs);
        assert_eq!(status, 200, "{guide} {knobs}: {body}");
        serde_json::from_str(&body).expect("JSON")
    }
}

/// A folder with the example of two structures under a record that makes them touch.
fn two(test: &str) -> std::path::PathBuf {
    let folder = folder(test);
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let record = here.join("../../studies/records/el-centro-1940-ns-chopra.csv");
    fs::copy(record, folder.join("record.csv")).expect("the record is there");
    fs::write(folder.join("scene.json"), good_scene().to_string()).expect("a disk");
    folder
}

/// A record of 10 s that changes its direction twice in a number of samples.
fn square_wave(period: i32) -> String {
    let samples = (0..1000).map(|index| {
        format!(
            "{},{}\n",
            f64::from(index) / 100.0,
            if index % period < period / 2 { 3 } else { -3 }
        )
    });
    "time_s,acceleration_m_per_s2\n".to_owned() + &samples.collect::<Vec<_>>().concat()
}

/// Largest displacement of a floor \[m\].
fn peak(run: &Value, floor: usize) -> f64 {
    let peak = run["summary"]["structures"][floor]["peak_displacement_m"].as_f64();
    peak.expect("a peak").abs()
}

fn collisions(run: &Value) -> u64 {
    let pairs = run["summary"]["pairs"].as_array().expect("pairs").iter();
    pairs.map(|pair| pair["collisions"].as_u64().expect("a count")).sum()
}

/// A summary without the run under a band-limited record, which the page leaves out.
fn without_second_run(mut summary: Value) -> Value {
    summary.as_object_mut().expect("an object").remove("between_samples");
    summary
}

#[test]
fn reference_the_page_shows_the_numbers_of_run() {
    let folder = two("view_numbers");
    let serving = Serving::of(&folder, &["scene.json"]);
    let printed = |scene: &str| -> Value {
        let ended = pounding(&folder, &["run", scene, "--json"]);
        without_second_run(serde_json::from_str(&ended.stdout).expect("a summary"))
    };
    let (fact, run) = serving.run("", &json!({}));
    assert_eq!(run["summary"], printed("scene.json"));
    assert_eq!(fact, Value::Null);
    assert!(
        run["answer"].as_str().is_some_and(|answer| answer.contains("floors touch")),
        "{}",
        run["answer"]
    );

    // A turned scene that was saved gives the numbers that were seen.
    let knobs = json!({"gap.0": 0.02, "mass.0": 1e5, "period.0": 0.9, "yield.0": 2e5, "law.0": "hertz_damp", "stiffness.0": 2, "restitution.0": 0.5,
        "damping.1": 0.03, "scale": 1.2, "direction": "reversed", "method": "central_difference", "step": "0.0025"});
    let (_, run) = serving.run("", &knobs);
    let (status, name) = serving.call("save", 1, "", &knobs);
    assert_eq!((status, name.as_str()), (200, "scene-turned-1.json"));
    assert_eq!(run["summary"], printed(&name));
    let structure = &run["summary"]["structures"][0];
    assert!((structure["period_s"].as_f64().unwrap() / 0.9 - 1.0).abs() < 1e-12, "{structure}");
    assert!(run["exact_um"].is_array(), "the exact method stands beside one with steps");
    for knob in run["knobs"].as_array().expect("knobs") {
        let asked = &knobs[knob["id"].as_str().expect("an id")];
        let near = |(found, asked): (f64, f64)| (found / asked - 1.0).abs() < 1e-9;
        let is_near = knob["value"].as_f64().zip(asked.as_f64()).is_some_and(near);
        assert!(asked.is_null() || is_near || knob["value"] == *asked, "{knob} of {asked}");
    }
}

#[test]
fn reference_save_writes_a_new_file_beside_the_scene_alone() {
    let folder = two("view_save");
    let before = fs::read(folder.join("scene.json")).expect("the scene");
    let serving = Serving::of(&folder, &["scene.json"]);
    for name in ["scene-turned-1.json", "scene-turned-2.json"] {
        assert_eq!(serving.call("save", 1, "", &json!({"gap.0": 0.02})), (200, name.into()));
    }
    assert_eq!(serving.call("save", 1, "wider", &json!({})).0, 404, "a guide has no folder");
    assert_eq!(serving.call("save", 1, "", &json!({"gap.0": -1})).0, 422);
    serving.run("", &json!({}));
    assert_eq!(serving.call("report", 1, "", &json!({})).0, 200);
    assert_eq!(serving.call("python", 1, "", &json!({})).0, 200);
    let mut names: Vec<_> = fs::read_dir(&folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").file_name())
        .collect();
    names.sort();
    assert_eq!(names, ["record.csv", "scene-turned-1.json", "scene-turned-2.json", "scene.json"]);
    assert_eq!(fs::read(folder.join("scene.json")).expect("the scene"), before);

    let own = Serving::of(&folder, &[]);
    let (status, said) = own.call("save", 1, "", &json!({}));
    assert_eq!(status, 422);
    assert!(said.contains("in no file"), "{said}");
}

#[test]
fn extreme_the_server_refuses_what_is_not_its_page() {
    let folder = folder("view_refusals");
    let serving = Serving::of(&folder, &[]);
    let (host, token) = (format!("Host: {}", serving.host), format!("X-Pounding-Token: {}", serving.token));
    let (host, token) = (host.as_str(), token.as_str());
    let origin = format!("Origin: http://{}", serving.host);
    let localhost = serving.host.replace("127.0.0.1", "localhost");
    let page = "GET / HTTP/1.1";
    assert_eq!(serving.status(&[page, host], ""), 200);
    assert_eq!(serving.status(&[page, host, &origin], ""), 200);
    for other in [
        "Host: example.org",
        "Host: 127.0.0.1",
        &format!("Host: {localhost}"),
        "Host:",
        "Accept: */*",
    ] {
        assert_eq!(serving.status(&[page, other], ""), 403, "{other}");
    }
    assert_eq!(serving.status(&[page, host, "Host: example.org"], ""), 400);
    for other in [
        "Origin: http://example.org",
        "Origin: null",
        &format!("Origin: https://{}", serving.host),
    ] {
        assert_eq!(serving.status(&[page, host, other], ""), 403, "{other}");
        assert_eq!(serving.status(&["POST /api/run HTTP/1.1", host, token, other], ""), 403, "{other}");
    }

    let call = "POST /api/guides HTTP/1.1";
    let body = json!({"window": 1, "guide": "", "knobs": {}}).to_string();
    let length = format!("Content-Length: {}", body.len());
    assert_eq!(serving.status(&[call, host, token, &length], &body), 200);
    assert_eq!(serving.status(&[call, host, &length], &body), 403);
    let wrong = format!("{}0", &token[..token.len() - 1]);
    let wrong = if wrong == token {
        format!("{}1", &token[..token.len() - 1])
    } else {
        wrong
    };
    for other in [&wrong, &token[..token.len() - 1], &format!("{token}0"), "X-Pounding-Token:"] {
        assert_eq!(serving.status(&[call, host, other, &length], &body), 403, "{other}");
    }

    for path in [
        "/../Cargo.toml",
        "/etc/passwd",
        "//",
        "/main.js/",
        "/index.html",
        "/?token=1",
        "http://example.org/",
        "/%2e%2e/",
    ] {
        assert_eq!(serving.status(&[&format!("GET {path} HTTP/1.1"), host], ""), 404, "{path}");
    }
    assert_eq!(serving.status(&["POST /api/none HTTP/1.1", host, token, &length], &body), 404);
    for method in ["PUT /", "POST /", "DELETE /main.js", "GET /api/run", "OPTIONS /api/run", "HEAD /"] {
        assert_eq!(serving.status(&[&format!("{method} HTTP/1.1"), host, token], ""), 405, "{method}");
    }
    for body in ["", "{}", "[", r#"{"window": 1, "guide": "", "knobs": {}, "scene": "/etc/passwd"}"#] {
        let length = format!("Content-Length: {}", body.len());
        assert_eq!(serving.status(&[call, host, token, &length], body), 400, "{body}");
    }
    for bytes in [&b"\x16\x03\x01\x02\x00\x01\x00"[..], b"GET\r\n\r\n", b"\0\0\0\0"] {
        assert_eq!(serving.sent(bytes).0, 400, "{bytes:?}");
    }
}

#[test]
fn extreme_the_server_bears_long_and_many_requests() {
    let folder = folder("view_many");
    let serving = Serving::of(&folder, &[]);
    let (host, token) = (format!("Host: {}", serving.host), format!("X-Pounding-Token: {}", serving.token));
    let (host, token) = (host.as_str(), token.as_str());
    let call = "POST /api/run HTTP/1.1";
    assert_eq!(
        serving.status(&[call, host, token, "Content-Length: 100000000"], &"x".repeat(1 << 20)),
        413
    );
    for length in ["-1", "1e3", "99999999999999999999999", "x"] {
        assert_eq!(
            serving.status(&[call, host, token, &format!("Content-Length: {length}")], ""),
            400,
            "{length}"
        );
    }
    assert_eq!(serving.status(&[call, host, token, "Transfer-Encoding: chunked"], "0\r\n\r\n"), 411);
    assert_eq!(
        serving.status(&["GET / HTTP/1.1", host, &format!("A: {}", "x".repeat(1 << 17))], ""),
        431
    );
    let many = vec!["A: b"; 100];
    assert_eq!(serving.status(&[&["GET / HTTP/1.1", host], &many[..]].concat(), ""), 400);

    // A thousand senders that never finish a request: those beyond the bound are turned away, and later ones are served.
    let open: Vec<TcpStream> = (0..1000).filter_map(|_| TcpStream::connect(&serving.host).ok()).collect();
    assert!(open.len() > 500, "{} connections", open.len());
    for mut stream in &open {
        let _ = stream.write_all(b"GET / HTTP/1.1\r\n");
    }
    assert_eq!(serving.status(&["GET / HTTP/1.1", host], ""), 503);
    for stream in &open {
        let _ = stream.shutdown(Shutdown::Both);
    }
    let served = (0..100).any(|_| {
        thread::sleep(Duration::from_millis(100));
        serving.status(&["GET / HTTP/1.1", host], "") == 200
    });
    assert!(served, "the server goes on");
}

#[test]
fn reference_a_dropped_record_shakes_the_scene_and_is_written_nowhere() {
    let folder = two("view_record");
    let mut scene = good_scene();
    scene["record"]["file"] = json!("other.csv");
    let other = square_wave(50);
    let serving = Serving::of(&folder, &["scene.json"]);
    let (status, key) = serving.under("other.csv", "record", other.as_bytes());
    assert_eq!(status, 200, "{key}");
    let (status, run) = serving.under(&key, "run", b"");
    assert_eq!(status, 200, "{run}");
    let run: Value = serde_json::from_str(&run).expect("JSON");
    assert_eq!(serving.under(&key, "save", b"").0, 422);
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 2, "nothing is written");

    fs::write(folder.join("other.csv"), &other).expect("a disk");
    fs::write(folder.join("other.json"), scene.to_string()).expect("a disk");
    let printed: Value = serde_json::from_str(&pounding(&folder, &["run", "other.json", "--json"]).stdout).expect("a summary");
    assert_eq!(run[1]["summary"], without_second_run(printed));

    // A wrong file is refused in the words of the reader, and its name opens no file.
    for (name, bytes) in [("letter.txt", &b"Dear friend"[..]), ("record.csv", b""), ("other.csv", b"\0\0\0\0")] {
        let (status, said) = serving.under(name, "record", bytes);
        assert_eq!(status, 422, "{name}: {said}");
        assert!(said.contains(name), "{said}");
    }
    assert_eq!(serving.under("none", "run", b"").0, 410);
    assert_eq!(serving.under("large.csv", "record", &vec![b'0'; 9 << 20]).0, 413);
    // Only the last records are kept.
    for n in 0..4 {
        assert_eq!(serving.under(&format!("{n}.csv"), "record", other.as_bytes()).0, 200);
    }
    assert_eq!(serving.under(&key, "run", b"").0, 410);
}

#[test]
fn extreme_the_latest_run_of_a_window_stops_the_one_before() {
    let folder = folder("view_latest");
    // The damper holds the pair together: this run has no end.
    let mut scene = good_scene();
    scene["contacts"][0]["law"] = json!({"kelvin_voigt": {"impact_stiffness_n_per_m": 9e7, "impact_damping_ratio": 1e9}});
    scene["contacts"][0]["gap_m"] = json!(0.001);
    scene["budget"] = json!({"pieces": 1e30});
    scene["method"] = json!("exact");
    fs::write(folder.join("scene.json"), scene.to_string()).expect("a disk");
    fs::write(folder.join("record.csv"), square_wave(100)).expect("a disk");
    let serving = Serving::of(&folder, &["scene.json"]);
    thread::scope(|scope| {
        let endless = scope.spawn(|| serving.call("run", 7, "", &json!({})));
        thread::sleep(Duration::from_millis(500));
        let apart = json!({"gap.0": 0.2, "scale": 0.1});
        assert_eq!(serving.call("run", 8, "", &apart).0, 200, "another window");
        assert!(!endless.is_finished(), "another window stops nothing");
        assert_eq!(serving.call("run", 7, "", &apart).0, 200);
        assert_eq!(endless.join().expect("an answer").0, 409);

        // A report and a run do not stop each other; the latest report wins.
        let endless = scope.spawn(|| serving.call("report", 7, "", &json!({})));
        thread::sleep(Duration::from_millis(500));
        assert_eq!(serving.call("run", 7, "", &apart).0, 200);
        assert!(!endless.is_finished(), "a run stops no report");
        assert_eq!(serving.call("report", 7, "", &apart).0, 200);
        assert_eq!(endless.join().expect("an answer").0, 409);

        // A window that closes stops its run.
        let endless = scope.spawn(|| serving.call("run", 7, "", &json!({})));
        thread::sleep(Duration::from_millis(500));
        assert_eq!(serving.call("stop", 7, "", &json!({})).0, 200);
        assert_eq!(endless.join().expect("an answer").0, 409);
    });
}

#[test]
fn reference_every_guide_shows_what_it_says() {
    let folder = folder("view_guides");
    let serving = Serving::of(&folder, &[]);
    let (status, about) = serving.call("guides", 1, "", &json!({}));
    assert_eq!(status, 200, "{about}");
    let about: Value = serde_json::from_str(&about).expect("JSON");
    for guide in about["guides"].as_array().expect("guides") {
        let key = guide["key"].as_str().expect("a key");
        let (_, run) = serving.run(key, &json!({}));
        assert!(collisions(&run) > 0, "{key}");
        let known: Vec<_> = run["knobs"].as_array().expect("knobs").iter().map(|knob| &knob["id"]).collect();
        for knob in guide["knobs"].as_array().expect("knobs") {
            assert!(known.contains(&knob), "{key}: {knob}");
        }
    }

    let at = |guide: &str, knobs: Value| serving.run(guide, &knobs).1;
    let force = |run: &Value| run["summary"]["pairs"][0]["peak_force_n"].as_f64().expect("a force");
    // A wider gap is worse.
    let [narrow, wide] = [0.04, 0.06].map(|gap| at("wider", json!({"gap.0": gap})));
    assert!(force(&wide) > 1.3 * force(&narrow), "{} and {}", force(&narrow), force(&wide));
    assert!(
        peak(&wide, 1) > 1.15 * peak(&narrow, 1),
        "{} and {}",
        peak(&narrow, 1),
        peak(&wide, 1)
    );
    // Half the step, twice the quotient.
    let quotient = |step: f64| {
        let run = at("step", json!({"step": step.to_string()}));
        run["summary"]["pairs"][0]["largest"]["impulse_n_s"].as_f64().expect("an impulse") / step
    };
    let times = quotient(0.0025) / quotient(0.005);
    assert!((1.7..2.3).contains(&times), "{times}");
    // The direction decides.
    let [given, reversed] = ["as given", "reversed"].map(|way| at("mirrored", json!({"direction": way})));
    assert_ne!(collisions(&given), collisions(&reversed));
    // A blow of the same energy has 10^0.4 times the force at ten times the stiffness; here the blow grows, too.
    let [soft, stiff] = [1.0, 10.0].map(|times| at("law", json!({"stiffness.0": times})));
    assert!(
        (2.5..3.2).contains(&(force(&stiff) / force(&soft))),
        "{} and {}",
        force(&soft),
        force(&stiff)
    );
    // The neighbours hold the building in the middle.
    let [held, free] = [0.03, 0.2].map(|gap| at("middle", json!({"gap.0": gap, "gap.1": gap})));
    assert!(peak(&held, 1) < 0.8 * peak(&free, 1), "{} and {}", peak(&held, 1), peak(&free, 1));
}

#[test]
fn reference_the_guides_of_the_slip_and_of_dampers_show_what_they_say() {
    let folder = folder("view_more_guides");
    let serving = Serving::of(&folder, &[]);
    let at = |guide: &str, knobs: Value| serving.run(guide, &knobs).1;
    // Half the step moves the momenta, which the paper denies; the exact ones are half as large again.
    let momenta = |knobs: Value| {
        let structures = at("slip", knobs)["summary"]["structures"].clone();
        let of = |one: usize| structures[one]["transferred_momentum_n_s"].as_f64().expect("a momentum");
        [of(0), of(1), of(2)]
    };
    let [whole, half, exact] = [json!({}), json!({"step": "0.0025"}), json!({"method": "exact"})].map(momenta);
    for one in 0..3 {
        let (half, exact) = (half[one] / whole[one], exact[one] / whole[one]);
        assert!((1.12..1.2).contains(&half), "{one}: {half}");
        assert!((1.45..1.6).contains(&exact), "{one}: {exact}");
    }
    // A damper halves the hardest blow, a larger one prevents it, and one that is too large ties the towers together.
    let damped = |coefficient: f64| at("dampers", json!({"link.0": coefficient}));
    let hardest = |run: &Value| run["summary"]["pairs"][3]["largest"]["impulse_n_s"].as_f64();
    let blows = [1e3, 1e5, 8e5].map(|coefficient| hardest(&damped(coefficient)).expect("a blow"));
    assert!(
        blows[1] > 0.99 * blows[0] && (0.45..0.55).contains(&(blows[2] / blows[0])),
        "{blows:?}"
    );
    assert_eq!(collisions(&damped(2e6)), 0);
    let [bare, tied] = [1e3, 2e7].map(|coefficient| peak(&damped(coefficient), 0));
    assert!(tied > 0.9 * bare, "{tied} and {bare}");
    let run = damped(1e5);
    assert_eq!(run["player"]["links"].as_array().map(Vec::len), Some(4));
    let method = run["knobs"]
        .as_array()
        .expect("knobs")
        .iter()
        .find(|knob| knob["id"] == "method")
        .expect("a method");
    let methods: Vec<_> = method["options"]
        .as_array()
        .expect("options")
        .iter()
        .map(|option| &option[0])
        .collect();
    let with_links = ["exact", "central_difference", "central_difference_10_contact_substeps", "rk4"];
    assert_eq!(methods, with_links, "the others take no links");
}

#[test]
fn extreme_a_scene_that_cannot_run_says_why() {
    let folder = folder("view_faults");
    let mut scene = good_scene();
    scene["contacts"][0]["gap_m"] = json!(-1);
    fs::write(folder.join("scene.json"), scene.to_string()).expect("a disk");
    fs::write(folder.join("record.csv"), quiet(10)).expect("a disk");
    let ended = pounding(&folder, &["view", "--no-open", "scene.json"]);
    assert_eq!((ended.code, ended.stdout.as_str()), (1, ""), "{}", ended.stderr);
    assert!(ended.stderr.contains("gap_m"), "{}", ended.stderr);

    let ended = pounding(&folder, &["view", "--no-open", "none.toml"]);
    assert_eq!(ended.code, 1);
    assert!(ended.stderr.contains("none.toml"), "{}", ended.stderr);
}
