//! The command `lt`: shadows by any technique, what they cost, and where they are wrong.
//!
//! No rendering happens here: every subcommand reads arguments, asks `lt_render`, and writes files.

mod args;
mod command_line;
mod compare;
mod desktop;
mod doctor;
mod error_map;
mod exr_file;
mod failure;
mod files;
#[cfg(test)]
mod fixture;
mod frame_args;
mod numbers;
mod pareto;
mod picture;
mod plan;
mod play;
mod progress;
mod render;
mod report;
mod results;
mod scene_args;
mod scenes;
mod summary;
mod table;
mod threads;
mod values;

use std::process::ExitCode;

use clap::Parser;
use tracing_subscriber::EnvFilter;

use crate::args::{Cli, Command};

fn main() -> ExitCode {
    desktop::is_not_asked_where_there_is_none();
    let cli = Cli::parse();
    let filter = EnvFilter::try_from_default_env().unwrap_or_else(|_| EnvFilter::new("error"));
    tracing_subscriber::fmt().with_env_filter(filter).with_writer(std::io::stderr).init();
    match threads::start(cli.command.threads()).and_then(|()| run(&cli.command)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => failure::report(&error),
    }
}

fn run(command: &Command) -> anyhow::Result<()> {
    match command {
        Command::Compare(args) => compare::run(args),
        Command::Render(args) => render::run(args),
        Command::Plan(args) => plan::run(args),
        Command::Scenes => scenes::run(),
        Command::Doctor => doctor::run(),
    }
}
