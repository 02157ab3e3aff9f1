//! `lt plan`: which effects a scene and a technique call for, why, and what each costs.

use std::io::Write;

use lt_render::{EffectPlan, Upkeep};

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
    let opened = args.scene.open(&[technique], Upkeep::Kept)?;
    let plan = opened.session.plan(&technique);
    writeln!(std::io::stdout(), "{} by {technique}\n\n{}", opened.name, text(&plan))?;
    Ok(())
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
    #[test]
    fn effects_are_told_on_from_off() {
        let rows = crate::fixture::comparison().rows;
        assert!(super::text(&rows[0].plan).contains("rays    on  a test"));
        assert!(super::text(&rows[1].plan).contains("rays    off  a test"));
    }
}
