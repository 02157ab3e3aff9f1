//! `cargo xtask ci`: every check that gates a change, except the tests.

use std::time::{Duration, Instant};

use anyhow::{Result, bail};

use crate::workspace::{cargo, run as run_command};
use crate::{check_shaders, no_std};

/// A named check.
struct Step {
    name: &'static str,
    check: fn() -> Result<()>,
}

const STEPS: [Step; 6] = [
    Step { name: "format", check: || call(&["fmt", "--all", "--check"], &[]) },
    Step {
        name: "clippy",
        check: || call(&["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"], &[]),
    },
    Step {
        // By themselves: with the whole workspace, the tests would switch the feature on again.
        name: "clippy without gpu",
        check: || {
            let packages = ["clippy", "-p", "lt-render", "-p", "lt-cli", "--no-default-features"];
            call(&[&packages[..], &["--all-targets", "--", "-D", "warnings"]].concat(), &[])
        },
    },
    Step {
        name: "rustdoc",
        check: || call(&["doc", "--workspace", "--no-deps"], &[("RUSTDOCFLAGS", "-D warnings")]),
    },
    Step { name: "no-std", check: no_std::run },
    Step { name: "shaders", check: check_shaders::run },
];

/// Runs all steps, also after a failure, and sums up.
///
/// # Errors
/// At least one step failed; the message names them.
pub fn run() -> Result<()> {
    let mut outcomes = Vec::new();
    for step in &STEPS {
        println!("== {}", step.name);
        let start = Instant::now();
        let outcome = (step.check)();
        if let Err(error) = &outcome {
            eprintln!("{error:#}");
        }
        outcomes.push((step.name, start.elapsed(), outcome.is_ok()));
    }
    println!("== summary");
    for (name, time, passed) in &outcomes {
        println!("{name:<20} {:>7.1} s  {}", time.as_secs_f64(), if *passed { "ok" } else { "FAILED" });
    }
    verdict(&outcomes)
}

/// An error that names every failed step.
fn verdict(outcomes: &[(&str, Duration, bool)]) -> Result<()> {
    let failed: Vec<&str> =
        outcomes.iter().filter(|(_, _, passed)| !passed).map(|(name, ..)| *name).collect();
    if failed.is_empty() {
        return Ok(());
    }
    bail!("failed: {}", failed.join(", "))
}

/// Runs cargo with arguments and environment variables.
fn call(args: &[&str], variables: &[(&str, &str)]) -> Result<()> {
    run_command(cargo().args(args).envs(variables.iter().copied()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_failed_step_fails_the_gate_by_name() {
        let second = Duration::from_secs(1);
        assert!(verdict(&[("a", second, true), ("b", second, true)]).is_ok());
        let error = verdict(&[("a", second, true), ("b", second, false)]).unwrap_err();
        assert_eq!(error.to_string(), "failed: b");
    }
}
