//! A program in a process of its own, which answers a line with a line.
//!
//! Two threads read what it writes, so that no pipe fills up and nothing waits longer than the time that it has. A
//! process that hangs, or writes what cannot be read, is killed; the next question starts another one. A program that
//! ends after an answer, with success, is started for each question.

use std::collections::VecDeque;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

use serde_json::Value;
use sweep_cdt_testing::judge::{Claims, Fault, Outcome, Question, json};

/// A longer line is no answer.
const LINE: u64 = 1 << 26;
/// So many lines of what a program writes on standard error are kept.
const KEPT: usize = 12;

/// A program that is asked.
pub(crate) struct Program {
    command: Vec<String>,
    timeout: Duration,
    running: Option<Running>,
    version: Option<String>,
}

/// A process of the program.
struct Running {
    child: Child,
    stdin: ChildStdin,
    lines: Receiver<String>,
    errors: Arc<Mutex<VecDeque<String>>>,
    has_answered: bool,
}

/// What a process did with a question.
enum Answer {
    Line(String),
    Hang,
    /// The process ended, with this status and these last words.
    End {
        is_success: bool,
        how: String,
    },
}

impl Program {
    /// The program, started once.
    pub(crate) fn start(command: &[String], timeout: Duration) -> Result<Program, String> {
        let running = Some(Running::start(command)?);
        let command = command.to_vec();
        Ok(Program {
            command,
            timeout,
            running,
            version: None,
        })
    }

    /// Asks the simplest question, which no program can fail to answer but one that is called wrongly.
    pub(crate) fn greet(&mut self, claims: &Claims) -> Result<(), String> {
        match self.ask(&claims.simplest()) {
            Outcome::Failed(Fault { name, what }) => {
                let line = json::question_line(&claims.simplest());
                Err(format!(
                    "the program does not answer a single triangle ({name}: {what})\nasked: {line}"
                ))
            }
            _ => Ok(()),
        }
    }

    /// The command line.
    pub(crate) fn command(&self) -> String {
        self.command.join(" ")
    }

    /// What the program says that it is: the member `program` of an answer.
    pub(crate) fn version(&self) -> &str {
        self.version.as_deref().unwrap_or("no answer names it")
    }

    /// Asks a question.
    pub(crate) fn ask(&mut self, question: &Question) -> Outcome {
        let line = json::question_line(question);
        let had_answered = self
            .running
            .as_ref()
            .is_some_and(|running| running.has_answered);
        let outcome = match self.answer(&line) {
            // A program that answers one question each time that it is started.
            Answer::End {
                is_success: true, ..
            } if had_answered => {
                let answer = self.answer(&line);
                self.outcome(answer)
            }
            answer => self.outcome(answer),
        };
        if matches!(&outcome, Outcome::Failed(_)) {
            self.running = None;
        }
        outcome
    }

    fn outcome(&mut self, answer: Answer) -> Outcome {
        let failed = |name, what: String| Outcome::Failed(Fault::new(name, what));
        match answer {
            Answer::Line(line) => {
                if self.version.is_none() {
                    let value: Option<Value> = serde_json::from_str(&line).ok();
                    let name = value
                        .as_ref()
                        .and_then(|value| value.get("program")?.as_str());
                    self.version = name.map(str::to_owned);
                }
                json::read_answer(&line)
            }
            Answer::Hang => failed("hang", format!("no answer within {:?}", self.timeout)),
            Answer::End { how, .. } => failed("crash", how),
        }
    }

    /// What a process, started if there is none, does with a line. One that does not answer is gone after that.
    fn answer(&mut self, line: &str) -> Answer {
        let mut running = match self
            .running
            .take()
            .map_or_else(|| Running::start(&self.command), Ok)
        {
            Ok(running) => running,
            Err(how) => {
                return Answer::End {
                    is_success: false,
                    how,
                };
            }
        };
        // A process that has ended cannot be written to; what it did then is found by waiting for it.
        let _ = writeln!(running.stdin, "{line}").and_then(|()| running.stdin.flush());
        match running.lines.recv_timeout(self.timeout) {
            Ok(line) => {
                running.has_answered = true;
                self.running = Some(running);
                Answer::Line(line)
            }
            Err(RecvTimeoutError::Timeout) => Answer::Hang,
            Err(RecvTimeoutError::Disconnected) => running.end(self.timeout),
        }
    }
}

impl Running {
    fn start(command: &[String]) -> Result<Running, String> {
        let [name, arguments @ ..] = command else {
            return Err("there is no program".to_owned());
        };
        let mut started = Command::new(name);
        started
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let mut child = started
            .spawn()
            .map_err(|error| format!("cannot start {name}: {error}"))?;
        let (Some(stdin), Some(stdout), Some(stderr)) =
            (child.stdin.take(), child.stdout.take(), child.stderr.take())
        else {
            return Err(format!("{name} has no pipes"));
        };
        let (sender, lines) = channel();
        thread::spawn(move || {
            let mut stdout = BufReader::new(stdout);
            loop {
                let mut line = Vec::new();
                let read = (&mut stdout).take(LINE).read_until(b'\n', &mut line);
                let is_end = !matches!(read, Ok(count) if count > 0);
                if is_end
                    || sender
                        .send(String::from_utf8_lossy(&line).into_owned())
                        .is_err()
                {
                    break;
                }
            }
        });
        let errors = Arc::new(Mutex::new(VecDeque::new()));
        let kept = Arc::clone(&errors);
        thread::spawn(move || {
            for line in BufReader::new(stderr).split(b'\n').map_while(Result::ok) {
                let Ok(mut kept) = kept.lock() else { break };
                kept.push_back(String::from_utf8_lossy(&line).into_owned());
                if kept.len() > KEPT {
                    kept.pop_front();
                }
            }
        });
        Ok(Running {
            child,
            stdin,
            lines,
            errors,
            has_answered: false,
        })
    }

    /// How a process ended that closed its output. One that goes on all the same is killed.
    fn end(mut self, timeout: Duration) -> Answer {
        let pause = Duration::from_millis(5);
        let mut waited = Duration::ZERO;
        let status = loop {
            match self.child.try_wait() {
                Ok(None) if waited < timeout => {
                    thread::sleep(pause);
                    waited += pause;
                }
                Ok(status) => break status,
                Err(_) => break None,
            }
        };
        let mut how = match status {
            Some(status) => format!("{status}"),
            None => "it closed its output and did not end".to_owned(),
        };
        if let Ok(errors) = self.errors.lock() {
            how.extend(errors.iter().map(|line| format!("\n{line}")));
        }
        let is_success = status.is_some_and(|status| status.success());
        Answer::End { is_success, how }
    }
}

impl Drop for Running {
    /// Leaves no process behind.
    fn drop(&mut self) {
        // What has ended cannot be killed.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
