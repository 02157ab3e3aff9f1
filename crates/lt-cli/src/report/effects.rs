//! The effect plans of all techniques in one table: effects that all agree on, once; the others by technique.

use lt_render::{Effect, Row};
use serde::Serialize;

/// All effects in plan order.
#[derive(Debug, Serialize)]
pub struct EffectTable(Vec<EffectGroup>);

/// One effect.
#[derive(Debug, Serialize)]
struct EffectGroup {
    name: &'static str,
    cases: Vec<Case>,
}

/// Techniques for which an effect is on or off for the same reason at the same cost.
#[derive(Debug, Serialize)]
struct Case {
    is_on: bool,
    reason: String,
    cost: String,
    techniques: String,
}

/// An effect as one plan states it, and the ids of the techniques whose plans say the same.
type Agreement<'a> = (&'a Effect, Vec<String>);

impl EffectTable {
    /// Groups the plans of `rows`.
    pub fn of(rows: &[Row]) -> Self {
        let mut groups: Vec<(&'static str, Vec<Agreement>)> = Vec::new();
        for row in rows {
            for effect in &row.plan.effects {
                let at = groups.iter().position(|g| g.0 == effect.name).unwrap_or_else(|| {
                    groups.push((effect.name, Vec::new()));
                    groups.len() - 1
                });
                let cases = &mut groups[at].1;
                let id = row.technique.to_string();
                match cases.iter_mut().find(|c| c.0 == effect) {
                    Some(case) => case.1.push(id),
                    None => cases.push((effect, vec![id])),
                }
            }
        }
        let group = |(name, cases): (&'static str, Vec<Agreement>)| {
            let is_shared = cases.len() == 1 && cases[0].1.len() == rows.len();
            let case = |(effect, ids): Agreement| Case {
                is_on: effect.is_on,
                reason: effect.reason.clone(),
                cost: effect.cost.clone(),
                techniques: if is_shared { "all".to_owned() } else { ids.join(", ") },
            };
            EffectGroup { name, cases: cases.into_iter().map(case).collect() }
        };
        Self(groups.into_iter().map(group).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_cases_share_a_line() {
        let mut rows = crate::fixture::comparison().rows;
        let table = EffectTable::of(&rows);
        assert_eq!((table.0.len(), table.0[0].cases.len()), (1, 2));
        assert_eq!(table.0[0].cases[1].techniques, "sm");
        rows[1].plan = rows[0].plan.clone();
        let table = EffectTable::of(&rows);
        assert_eq!((table.0[0].cases.len(), table.0[0].cases[0].techniques.as_str()), (1, "all"));
    }
}
