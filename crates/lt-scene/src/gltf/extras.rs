//! What a node's `extras` say about its mesh: `castShadow` and `receiveShadow`, the names that three.js gives them.

use serde_json::Value;

use super::json;
use crate::Repairs;

/// Whether the mesh at a node casts and receives shadows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shadows {
    pub(super) casts: bool,
    pub(super) receives: bool,
}

impl Default for Shadows {
    fn default() -> Self {
        Self { casts: true, receives: true }
    }
}

impl Shadows {
    /// Of node `index`. Extras are anyone's, so that what is no boolean is noted and ignored.
    pub(super) fn read(node: &json::Node, index: usize, repairs: &mut Repairs) -> Self {
        let mut flag = |name: &str| match node.extras.get(name) {
            None => true,
            Some(Value::Bool(flag)) => *flag,
            Some(other) => {
                repairs.notes.push(format!(
                    "nodes[{index}].extras.{name} is {}, not true or false, and was ignored",
                    kind(other)
                ));
                true
            }
        };
        Self { casts: flag("castShadow"), receives: flag("receiveShadow") }
    }
}

/// What a value is, in a word or its own short one.
fn kind(value: &Value) -> String {
    match value {
        Value::Array(_) => "an array".to_owned(),
        Value::Object(_) => "an object".to_owned(),
        Value::String(_) => "a string".to_owned(),
        short => short.to_string(),
    }
}
