//! Exit codes: 1 when a run failed, 2 when the user asked for something that cannot be.

use std::{io, process::ExitCode};

use lt_render::RenderError;
use lt_scene::SceneError;

/// A request that cannot be met as typed; the text names the option, the value and the remedy.
#[derive(Debug)]
pub struct Usage(pub String);

impl std::fmt::Display for Usage {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Usage {}

/// Prints the error on stderr and picks the exit code.
///
/// A reader that closed our stdout (`lt scenes | head -1`) has all it wanted: that is no failure.
pub fn report(error: &anyhow::Error) -> ExitCode {
    let is_closed_pipe =
        error.downcast_ref::<io::Error>().is_some_and(|e| e.kind() == io::ErrorKind::BrokenPipe);
    if is_closed_pipe {
        return ExitCode::SUCCESS;
    }
    eprintln!("error: {}", words(error));
    ExitCode::from(if is_usage(error) { 2 } else { 1 })
}

/// The error and its causes, leaving out a cause that the text before it already tells.
fn words(error: &anyhow::Error) -> String {
    error.chain().map(ToString::to_string).fold(String::new(), |text, cause| match text.as_str() {
        "" => cause,
        told if told.contains(&cause) => text,
        _ => format!("{text}: {cause}"),
    })
}

fn is_usage(error: &anyhow::Error) -> bool {
    error.is::<Usage>()
        || matches!(error.downcast_ref(), Some(SceneError::UnknownScene(_)))
        || matches!(error.downcast_ref(), Some(RenderError::BadSetup(_)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_told_twice() {
        let source = io::Error::other("gone");
        let error = anyhow::Error::from(SceneError::Io { path: "a.glb".into(), source }).context("scene");
        assert_eq!(words(&error), "scene: a.glb: gone");
    }

    #[test]
    fn bad_requests_and_failed_runs_differ() {
        assert!(is_usage(&Usage("--size".into()).into()));
        assert!(is_usage(&SceneError::UnknownScene("x".into()).into()));
        assert!(is_usage(&RenderError::BadSetup("x".into()).into()));
        assert!(is_usage(&anyhow::Error::from(RenderError::BadSetup("x".into())).context("scene street")));
        assert!(!is_usage(&RenderError::Cancelled.into()));
        assert!(!is_usage(&anyhow::anyhow!("disk full")));
    }
}
