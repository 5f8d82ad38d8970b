//! A headless Chromium, told what to do by Chromium's own driver (W3C `WebDriver`, JSON over HTTP).

use std::io::{self, BufRead, BufReader, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use serde_json::{Value, json};
use tempfile::TempDir;

/// A window of its own, closed when this goes.
pub(crate) struct Browser {
    driver: Child,
    port: u16,
    session: String,
    profile: TempDir,
}

/// Names that the browser and its driver have on one system or another.
const BROWSERS: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];
const DRIVER: &str = "chromedriver";
/// How long an answer may take.
const PATIENCE: Duration = Duration::from_secs(60);

impl Browser {
    /// A window of that size; none, and the reason printed, where there is no Chromium.
    pub(crate) fn open([width, height]: [u32; 2]) -> Option<Browser> {
        let found = |name: &str| {
            let paths = std::env::var_os("PATH").unwrap_or_default();
            let mut paths = std::env::split_paths(&paths).map(|folder| folder.join(name));
            paths.find(|path| path.is_file())
        };
        let Some(chromium) = BROWSERS.into_iter().find_map(found) else {
            eprintln!("skipped: none of {BROWSERS:?} is installed");
            return None;
        };
        let Some(driver) = found(DRIVER) else {
            eprintln!("skipped: {DRIVER} is not installed");
            return None;
        };
        let mut driver = Command::new(driver)
            .arg("--port=0")
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("the driver starts");
        let port = port(&mut driver);
        let profile = TempDir::new().expect("a temporary folder");
        let mut browser = Browser {
            driver,
            port,
            session: String::new(),
            profile,
        };
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
            format!("--user-data-dir={}", browser.profile.path().display()),
        ];
        let session = browser.post(
            "/session",
            &json!({"capabilities": {"alwaysMatch": {
                "goog:loggingPrefs": {"browser": "ALL"},
                "goog:chromeOptions": {"binary": chromium, "args": arguments},
            }}}),
        );
        let id = session["sessionId"].as_str().expect("a session");
        browser.session = format!("/session/{id}");
        // The inside of the window, whatever its frame takes.
        let metrics =
            json!({"width": width, "height": height, "deviceScaleFactor": 1, "mobile": false});
        let command = json!({"cmd": "Emulation.setDeviceMetricsOverride", "params": metrics});
        browser.tell("/goog/cdp/execute", &command);
        Some(browser)
    }

    /// Loads a file, with this after its name.
    pub(crate) fn load(&self, page: &Path, hash: &str) {
        let url = format!("file://{}{hash}", page.display());
        self.tell("/url", &json!({ "url": url }));
    }

    /// The value of a script's `return`.
    pub(crate) fn run(&self, script: &str) -> Value {
        self.tell("/execute/sync", &json!({"script": script, "args": []}))
    }

    /// The text of the element with this id.
    pub(crate) fn text(&self, id: &str) -> String {
        let text = self.run(&format!("return document.getElementById('{id}').innerText"));
        text.as_str().expect("a text").to_owned()
    }

    pub(crate) fn click(&self, id: &str) {
        let found = self.tell(
            "/element",
            &json!({"using": "css selector", "value": format!("#{id}")}),
        );
        let element = found.as_object().and_then(|found| found.values().next());
        let element = element.and_then(Value::as_str).expect("an element");
        self.tell(&format!("/element/{element}/click"), &json!({}));
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

    /// What the page has written to the console.
    pub(crate) fn console(&self) -> Vec<Value> {
        let log = self.tell("/se/log", &json!({"type": "browser"}));
        log.as_array().expect("a list").clone()
    }

    /// A picture of the window, as PNG.
    pub(crate) fn picture(&self) -> Vec<u8> {
        let picture = self.request("GET", &format!("{}/screenshot", self.session), "");
        from_base64(picture.as_str().expect("a picture"))
    }

    fn perform(&self, actions: &Value) {
        self.tell("/actions", &json!({ "actions": actions }));
    }

    fn tell(&self, command: &str, body: &Value) -> Value {
        self.post(&format!("{}{command}", self.session), body)
    }

    fn post(&self, path: &str, body: &Value) -> Value {
        self.request("POST", path, &body.to_string())
    }

    #[track_caller]
    fn request(&self, method: &str, path: &str, body: &str) -> Value {
        let (status, body) = self
            .exchange(method, path, body)
            .expect("the driver answers");
        let answer: Value = serde_json::from_slice(&body).expect("JSON");
        assert!(status.contains(" 200 "), "{path}: {answer}");
        answer["value"].clone()
    }

    /// Sends a request; returns the status line and the body of the answer.
    fn exchange(&self, method: &str, path: &str, body: &str) -> io::Result<(String, Vec<u8>)> {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port))?;
        stream.set_read_timeout(Some(PATIENCE))?;
        let length = body.len();
        write!(
            stream,
            "{method} {path} HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n\
             Content-Length: {length}\r\nConnection: close\r\n\r\n{body}"
        )?;
        answer(&mut BufReader::new(stream))
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        // Best effort: a failure of the test itself is the one to report.
        let _ = self.exchange("DELETE", &self.session, "");
        let _ = self.driver.kill();
        let _ = self.driver.wait();
    }
}

/// Reads an answer; the driver keeps the connection open after it.
fn answer(stream: &mut impl BufRead) -> io::Result<(String, Vec<u8>)> {
    let mut status = String::new();
    stream.read_line(&mut status)?;
    let mut length = 0;
    for line in stream.by_ref().lines() {
        let line = line?;
        match line.split_once(':') {
            None => break,
            Some((name, value)) if name.eq_ignore_ascii_case("content-length") => {
                length = value.trim().parse().map_err(io::Error::other)?;
            }
            Some(_) => {}
        }
    }
    let mut body = vec![0; length];
    stream.read_exact(&mut body)?;
    Ok((status, body))
}

/// The port that the driver says it listens at.
fn port(driver: &mut Child) -> u16 {
    let output = BufReader::new(driver.stdout.take().expect("a pipe"));
    let port = |line: String| {
        let (_, port) = line.split_once("successfully on port ")?;
        port.trim_end_matches('.').parse().ok()
    };
    let mut lines = output.lines().map_while(Result::ok);
    lines.find_map(port).expect("the driver tells its port")
}

fn from_base64(text: &str) -> Vec<u8> {
    const DIGITS: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let value = |digit: u8| DIGITS.iter().position(|&other| other == digit);
    let digits: Vec<usize> = text.bytes().filter_map(value).collect();
    let bytes = digits.chunks(4).flat_map(|four| {
        let number = (0..4).fold(0, |sum, at| sum << 6 | four.get(at).copied().unwrap_or(0));
        let bytes = [16, 8, 0].map(|shift| u8::try_from(number >> shift & 255).expect("a byte"));
        bytes.into_iter().take(four.len() - 1)
    });
    bytes.collect()
}
