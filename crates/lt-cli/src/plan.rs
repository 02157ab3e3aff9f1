//! `lt plan`: which effects a scene and a technique call for, why, and what each costs.

use std::io::Write;

use lt_render::{EffectPlan, Sequence, Upkeep};

use crate::{
    args::PlanArgs,
    table::{self, Align},
};

/// Runs the command.
///
/// # Errors
/// A bad request or a scene that cannot be read.
pub fn run(args: &PlanArgs) -> anyhow::Result<()> {
    let technique = args.technique.with(args.scene.technique_defaults());
    let mut opened = args.scene.open(&[technique], Upkeep::Kept)?;
    let sequence = args.play.sequence(&args.scene, &opened);
    opened.session.play(sequence);
    let plan = opened.session.plan(&technique);
    writeln!(
        std::io::stdout(),
        "{} by {technique}, {}\n\n{}",
        opened.name,
        headline(args.play.frames, sequence),
        text(&plan)
    )?;
    Ok(())
}

/// What was planned for; a single view says how to plan for more.
fn headline(frames: Option<u16>, sequence: Sequence) -> String {
    let Some(frames) = frames else {
        return "a single view (several frames: --frames N)".to_owned();
    };
    let moving = [
        (sequence.camera_moves, "the camera"),
        (sequence.objects_move, "things"),
        (sequence.lights_move, "lights"),
    ];
    let moving: Vec<&str> = moving.into_iter().filter(|m| m.0).map(|m| m.1).collect();
    match moving.is_empty() {
        true => format!("{frames} frames in which nothing moves"),
        false => format!("{frames} frames; what moves: {}", moving.join(", ")),
    }
}

fn text(plan: &EffectPlan) -> String {
    let columns =
        [("effect", Align::Left), ("", Align::Left), ("why", Align::Left), ("cost when on", Align::Left)];
    let row = |e: &lt_render::Effect| {
        vec![
            e.name.to_owned(),
            if e.is_on { "on" } else { "off" }.to_owned(),
            e.reason.clone(),
            e.cost.clone(),
        ]
    };
    table::render(&columns, &plan.effects.iter().map(row).collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use lt_render::Sequence;

    #[test]
    fn what_moves_is_named() {
        let still = Sequence { is_played: true, ..Sequence::default() };
        assert_eq!(super::headline(Some(4), still), "4 frames in which nothing moves");
        let moving = Sequence { camera_moves: true, lights_move: true, ..still };
        assert_eq!(super::headline(Some(4), moving), "4 frames; what moves: the camera, lights");
        assert!(super::headline(None, Sequence::default()).contains("--frames"));
    }

    #[test]
    fn effects_are_told_on_from_off() {
        let rows = crate::fixture::comparison().rows;
        assert!(super::text(&rows[0].plan).contains("rays    on  a test"));
        assert!(super::text(&rows[1].plan).contains("rays    off  a test"));
    }
}
