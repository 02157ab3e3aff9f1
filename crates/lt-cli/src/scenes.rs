//! `lt scenes`: the built-in scenes and what their number means.

use std::io::Write;

use lt_scene::builtin::{Builtin, Place};

use crate::{
    numbers::grouped,
    table::{self, Align},
};

/// Runs the command.
///
/// # Errors
/// Only if stdout cannot be written.
pub fn run() -> anyhow::Result<()> {
    let columns = [
        ("scene", Align::Left),
        ("number", Align::Left),
        ("default", Align::Right),
        ("range", Align::Left),
        ("what it shows", Align::Left),
    ];
    let row = |place: &Place| {
        let range =
            format!("{}–{}", grouped((*place.sizes.start()).into()), grouped((*place.sizes.end()).into()));
        vec![
            place.name.to_owned(),
            place.size_meaning.to_owned(),
            grouped(place.default_size.into()),
            range,
            place.summary.to_owned(),
        ]
    };
    let rows: Vec<_> = Builtin::catalogue().iter().map(row).collect();
    let mut out = std::io::stdout().lock();
    write!(out, "{}", table::render(&columns, &rows))?;
    writeln!(out, "\nType name or name:number, such as random:1000; --seed grows another of the kind.")?;
    writeln!(out, "A path of a .gltf or .glb file is a scene too.")?;
    Ok(())
}
