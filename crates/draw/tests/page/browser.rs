//! A headless Chromium, steered through Chromium's own driver (W3C `WebDriver`: JSON over HTTP).

use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use base64::prelude::{BASE64_STANDARD, Engine};
use serde_json::{Value, json};
use tempfile::TempDir;
use ureq::Agent;

/// A window of its own, closed when this is dropped.
pub(crate) struct Browser {
    driver: Child,
    agent: Agent,
    /// The address of the window's session.
    session: String,
    /// Kept while the browser uses it.
    _profile: TempDir,
}

/// Names that the browser and its driver have on one system or another.
const BROWSERS: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];
const DRIVER: &str = "chromedriver";
/// How long an answer may take.
const PATIENCE: Duration = Duration::from_secs(60);

/// The browser and its driver, or what is missing.
fn programs() -> Result<[PathBuf; 2], String> {
    let found = |name: &str| {
        let paths = std::env::var_os("PATH").unwrap_or_default();
        let mut paths = std::env::split_paths(&paths).map(|folder| folder.join(name));
        paths.find(|path| path.is_file())
    };
    let browser = BROWSERS.into_iter().find_map(found);
    let browser = browser.ok_or_else(|| format!("none of {BROWSERS:?} is installed"))?;
    let driver = found(DRIVER).ok_or_else(|| format!("{DRIVER} is not installed"))?;
    Ok([browser, driver])
}

impl Browser {
    /// A window of that size. Where there is no browser: none, and the reason printed; in continuous
    /// integration, where `CI` is `true`, a failure.
    pub(crate) fn open([width, height]: [u32; 2]) -> Option<Browser> {
        let [chromium, driver] = match programs() {
            Ok(programs) => programs,
            Err(missing) => {
                let is_ci = std::env::var_os("CI").is_some_and(|value| value == "true");
                assert!(!is_ci, "{missing}");
                eprintln!("skipped: {missing}");
                return None;
            }
        };
        let mut driver = Command::new(driver)
            .arg("--port=0")
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("the driver starts");
        let address = format!("http://127.0.0.1:{}/session", port(&mut driver));
        let profile = TempDir::new().expect("a temporary folder");
        let arguments = [
            "--headless".to_owned(),
            "--no-sandbox".to_owned(),
            "--disable-gpu".to_owned(),
            "--disable-quic".to_owned(),
            "--disable-dev-shm-usage".to_owned(),
            "--no-first-run".to_owned(),
            "--disable-background-networking".to_owned(),
            "--disable-component-update".to_owned(),
            "--disable-sync".to_owned(),
            "--hide-scrollbars".to_owned(),
            format!("--window-size={width},{height}"),
            format!("--user-data-dir={}", profile.path().display()),
        ];
        let config = Agent::config_builder()
            .timeout_global(Some(PATIENCE))
            .http_status_as_error(false);
        let mut browser = Browser {
            driver,
            agent: config.build().into(),
            session: address,
            _profile: profile,
        };
        let session = browser.send(
            "",
            &json!({"capabilities": {"alwaysMatch": {
                "goog:loggingPrefs": {"browser": "ALL"},
                "goog:chromeOptions": {"binary": chromium, "args": arguments},
            }}}),
        );
        let id = session["sessionId"].as_str().expect("a session");
        browser.session = format!("{}/{id}", browser.session);
        // The inside of the window, whatever its frame takes.
        let metrics =
            json!({"width": width, "height": height, "deviceScaleFactor": 1, "mobile": false});
        let command = json!({"cmd": "Emulation.setDeviceMetricsOverride", "params": metrics});
        browser.send("/goog/cdp/execute", &command);
        Some(browser)
    }

    /// Loads a file, with this after its name.
    pub(crate) fn load(&self, page: &Path, hash: &str) {
        let url = format!("file://{}{hash}", page.display());
        self.send("/url", &json!({ "url": url }));
    }

    /// The value of a script's `return`.
    pub(crate) fn run(&self, script: &str) -> Value {
        self.send("/execute/sync", &json!({"script": script, "args": []}))
    }

    /// The value that a script passes to `done`.
    pub(crate) fn run_async(&self, script: &str) -> Value {
        let script = format!("const done = arguments[0]; {script}");
        self.send("/execute/async", &json!({"script": script, "args": []}))
    }

    /// Asks for dark pages.
    pub(crate) fn darken(&self) {
        let dark = json!({"features": [{"name": "prefers-color-scheme", "value": "dark"}]});
        let command = json!({"cmd": "Emulation.setEmulatedMedia", "params": dark});
        self.send("/goog/cdp/execute", &command);
    }

    /// The text of the element with this id.
    pub(crate) fn text(&self, id: &str) -> String {
        let text = self.run(&format!("return document.getElementById('{id}').innerText"));
        text.as_str().expect("a text").to_owned()
    }

    pub(crate) fn click(&self, id: &str) {
        let found = self.found(id);
        let element = found.as_object().and_then(|found| found.values().next());
        let element = element.and_then(Value::as_str).expect("an element");
        self.send(&format!("/element/{element}/click"), &json!({}));
    }

    /// Presses and releases a key.
    pub(crate) fn press(&self, key: &str) {
        let actions = json!([{"type": "keyDown", "value": key}, {"type": "keyUp", "value": key}]);
        self.perform(&json!([{"type": "key", "id": "keys", "actions": actions}]));
    }

    /// Drags the mouse.
    pub(crate) fn drag(&self, from: [i64; 2], to: [i64; 2]) {
        let at = |[x, y]: [i64; 2]| json!({"type": "pointerMove", "duration": 50, "x": x, "y": y});
        let (down, up) = (
            json!({"type": "pointerDown", "button": 0}),
            json!({"type": "pointerUp", "button": 0}),
        );
        self.perform(
            &json!([{"type": "pointer", "id": "mouse", "actions": [at(from), down, at(to), up]}]),
        );
    }

    /// Turns the wheel over a place.
    pub(crate) fn wheel(&self, [x, y]: [i64; 2], turn: i64) {
        let turn = json!({"type": "scroll", "x": x, "y": y, "deltaX": 0, "deltaY": turn});
        self.perform(&json!([{"type": "wheel", "id": "wheel", "actions": [turn]}]));
    }

    /// The lines that the page has written to the console.
    pub(crate) fn console(&self) -> Vec<Value> {
        let log = self.send("/se/log", &json!({"type": "browser"}));
        log.as_array().expect("a list").clone()
    }

    /// A picture of the window, as PNG.
    pub(crate) fn picture(&self) -> Vec<u8> {
        let request = self.agent.get(format!("{}/screenshot", self.session));
        let picture = value(request.call());
        let picture = picture.as_str().expect("a picture");
        BASE64_STANDARD.decode(picture).expect("base64")
    }

    /// The element with this id, as the driver refers to it.
    pub(crate) fn found(&self, id: &str) -> Value {
        let query = json!({"using": "css selector", "value": format!("#{id}")});
        self.send("/element", &query)
    }

    fn perform(&self, actions: &Value) {
        self.send("/actions", &json!({ "actions": actions }));
    }

    /// Sends a command of `WebDriver`.
    #[track_caller]
    pub(crate) fn send(&self, command: &str, body: &Value) -> Value {
        let request = self.agent.post(format!("{}{command}", self.session));
        value(request.send(body.to_string()))
    }
}

/// The value in an answer of the driver.
#[track_caller]
fn value(answer: Result<ureq::http::Response<ureq::Body>, ureq::Error>) -> Value {
    let mut answer = answer.expect("the driver answers");
    let body = answer.body_mut().read_to_string().expect("a text");
    let body: Value = serde_json::from_str(&body).expect("JSON");
    assert!(answer.status().is_success(), "{body}");
    body["value"].clone()
}

impl Drop for Browser {
    fn drop(&mut self) {
        // Best effort: a failure of the test itself is the one to report.
        let _ = self.agent.delete(&self.session).call();
        let _ = self.driver.kill();
        let _ = self.driver.wait();
    }
}

/// The port that the driver listens at, which it prints.
fn port(driver: &mut Child) -> u16 {
    let output = BufReader::new(driver.stdout.take().expect("a pipe"));
    let port = |line: String| {
        let (_, port) = line.split_once("successfully on port ")?;
        port.trim_end_matches('.').parse().ok()
    };
    let mut lines = output.lines().map_while(Result::ok);
    lines.find_map(port).expect("the driver prints its port")
}
