//! Removes composite values and types that nothing uses from a SPIR-V module (SPIR-V specification 1.3, sections
//! 3.32.6 and 3.32.12).
//!
//! rust-gpu passes structs that hold slices as values, taken apart where they were put together; naga refuses types
//! of pointers within structs. Reads of members are therefore forwarded first, which leaves such structs unused. spirv-opt would remove them, and change the arithmetic as well.

use std::collections::{HashMap, HashSet};

use anyhow::Result;

use crate::strip::{join, opcode, split};

/// Annotations, whose first operand is what they describe: names, then decorations.
const ANNOTATIONS: [u32; 4] = [5, 6, 71, 72];

/// `OpExtension`, `OpExtInstImport`, `OpMemoryModel`, `OpEntryPoint`, `OpExecutionMode`, `OpCapability`: their first
/// operand is no result type.
const NO_RESULT_TYPE: [u32; 6] = [10, 11, 14, 15, 16, 17];

const OP_FUNCTION: u32 = 54;
const OP_COMPOSITE_EXTRACT: u32 = 81;
const OP_COMPOSITE_INSERT: u32 = 82;
const OP_COPY_OBJECT: u32 = 83;

/// `OpUndef`, `OpCompositeConstruct`, `OpCompositeExtract`, `OpCompositeInsert`: no effect but their result.
const COMPOSITES: [u32; 4] = [1, 80, 81, 82];

/// The module without unused composite values and types, their names and their decorations.
///
/// # Errors
/// `spirv` is not a SPIR-V module.
pub fn prune(spirv: &[u8]) -> Result<Vec<u8>> {
    let (header, mut instructions) = split(spirv)?;
    forward_members(&mut instructions);
    while drop_unused_composites(&mut instructions) {}
    let mut live: HashSet<u32> = HashSet::new();
    for words in &instructions {
        let code = opcode(words);
        if is_type(code) || ANNOTATIONS.contains(&code) || NO_RESULT_TYPE.contains(&code) {
            continue;
        }
        // Where an instruction has no result type this is some other id, which no type shares.
        live.extend(words.get(1));
        if code == OP_FUNCTION {
            live.extend(words.get(4));
        }
    }
    let mut dead = HashSet::new();
    // Types come before the types that use them, so one pass backwards sees every use first.
    for words in instructions.iter().rev().filter(|words| is_type(opcode(words))) {
        let Some(id) = words.get(1) else { continue };
        if live.contains(id) {
            live.extend(used_types(words));
        } else {
            dead.insert(*id);
        }
    }
    let kept = instructions.iter().filter(|words| {
        let describes = is_type(opcode(words)) || ANNOTATIONS.contains(&opcode(words));
        !(describes && words.get(1).is_some_and(|id| dead.contains(id)))
    });
    Ok(join(&header, kept))
}

/// Turns each read of a member that was put into a composite just before into a copy of what was put there.
fn forward_members(instructions: &mut [Vec<u32>]) {
    let inserts: HashMap<u32, Vec<u32>> = instructions
        .iter()
        .filter(|words| opcode(words) == OP_COMPOSITE_INSERT && words.len() > 5)
        .map(|words| (words[2], words[3..].to_vec()))
        .collect();
    for words in instructions.iter_mut() {
        if opcode(words) == OP_COMPOSITE_EXTRACT
            && words.len() > 4
            && let Some(member) = member(&inserts, words[3], &words[4..])
        {
            *words = vec![OP_COPY_OBJECT | 4 << 16, words[1], words[2], member];
        }
    }
}

/// The value put at exactly `path` of `composite`, if a chain of insertions tells.
fn member(inserts: &HashMap<u32, Vec<u32>>, mut composite: u32, path: &[u32]) -> Option<u32> {
    // Each entry is object, composite it was put into, then the path. The chain is acyclic in valid modules; the
    // count keeps invalid ones from looping.
    for _ in 0..=inserts.len() {
        let insert = inserts.get(&composite)?;
        let put = &insert[2..];
        if put == path {
            return Some(insert[0]);
        }
        if put.starts_with(path) || path.starts_with(put) {
            return None;
        }
        composite = insert[1];
    }
    None
}

/// Drops composite values that no instruction reads; returns whether there were any.
fn drop_unused_composites(instructions: &mut Vec<Vec<u32>>) -> bool {
    let used: HashSet<u32> = instructions.iter().flat_map(|words| read_values(words)).copied().collect();
    let is_dead = |words: &[u32]| {
        COMPOSITES.contains(&opcode(words)) && words.get(2).is_some_and(|id| !used.contains(id))
    };
    let dead: HashSet<u32> =
        instructions.iter().filter(|words| is_dead(words)).map(|words| words[2]).collect();
    instructions.retain(|words| {
        let annotates =
            ANNOTATIONS.contains(&opcode(words)) && words.get(1).is_some_and(|id| dead.contains(id));
        !annotates && !is_dead(words)
    });
    !dead.is_empty()
}

/// The operands of an instruction that may be values it reads; where unsure, literals too.
fn read_values(words: &[u32]) -> &[u32] {
    let range = match opcode(words) {
        code if is_type(code) || ANNOTATIONS.contains(&code) => 0..0,
        // OpUndef, scalar constants: a result, and literals at most.
        1 | 41 | 42 | 43 => 0..0,
        // Composite construct: all parts. Extract and insert: literal indices come last.
        80 => 3..words.len(),
        81 => 3..4,
        82 => 3..5,
        // Labels define; a variable's storage class is followed by its initial value.
        248 => 0..0,
        59 => 4..words.len(),
        _ => 1..words.len(),
    };
    words.get(range).unwrap_or_default()
}

/// `OpTypeVoid` to `OpTypeFunction`; this target has none of the later ones.
fn is_type(code: u32) -> bool {
    (19..=33).contains(&code)
}

/// The operands of a type instruction that are types, not literals.
fn used_types(words: &[u32]) -> &[u32] {
    let range = match opcode(words) {
        // Vector, matrix, image, sampled image, array, runtime array: the element comes first.
        23..=25 | 27..=29 => 2..3,
        // A struct's members; a function's result and parameters.
        30 | 33 => 2..words.len(),
        // A pointer's storage class stands before its pointee.
        32 => 3..4,
        _ => 0..0,
    };
    words.get(range).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::module::tests::minimal;

    /// The least shader with type instructions put before its `OpTypeVoid`, which starts at word 23 of the module.
    fn with_types(extra: &[u32]) -> Vec<u8> {
        let mut module = minimal();
        let at = 21 * 4;
        let bytes: Vec<u8> = extra.iter().flat_map(|word| word.to_le_bytes()).collect();
        module.splice(at..at, bytes);
        module
    }

    #[test]
    fn chains_of_unused_types_go_with_their_annotations() {
        // OpName %8; %7 = OpTypeFloat 32; %8 = OpTypePointer Function %7; %9 = OpTypeStruct %8.
        let unused = [0x0003_0005, 8, 0, 0x0003_0016, 7, 32, 0x0004_0020, 8, 7, 7, 0x0003_001e, 9, 8];
        let module = with_types(&unused);
        assert!(module.len() > minimal().len());
        assert_eq!(prune(&module).unwrap(), minimal());
    }

    #[test]
    fn unused_composites_go_and_read_ones_stay() {
        // %7 = OpTypeFloat 32; %8 = OpTypeVector %7 2; %9 = OpUndef %8; %10 = OpCompositeInsert %8 %9 %9 0
        let types = [0x0003_0016, 7, 32, 0x0004_0017, 8, 7, 2, 0x0003_0001, 8, 9];
        let insert = [0x0006_0052, 8, 10, 9, 9, 0];
        let dead = with_types(&[&types[..], &insert].concat());
        assert_eq!(prune(&dead).unwrap(), minimal());
        // OpStore %11 %10
        let read = with_types(&[&types[..], &insert, &[0x0003_003e, 11, 10]].concat());
        assert_eq!(prune(&read).unwrap(), read);
    }

    #[test]
    fn a_member_read_is_what_was_put_there() {
        let inserts = HashMap::from([(20, vec![5, 19, 0, 1]), (21, vec![6, 20, 1])]);
        assert_eq!(member(&inserts, 21, &[1]), Some(6));
        assert_eq!(member(&inserts, 21, &[0, 1]), Some(5), "through the later insertion");
        assert_eq!(member(&inserts, 21, &[0]), None, "only a part of it is known");
        assert_eq!(member(&inserts, 21, &[1, 0]), None, "a part of what was put");
        assert_eq!(member(&inserts, 21, &[2]), None);
        let cycle = HashMap::from([(20, vec![5, 20, 0])]);
        assert_eq!(member(&cycle, 20, &[1]), None);
    }

    #[test]
    fn what_is_used_stays() {
        assert_eq!(prune(&minimal()).unwrap(), minimal());
        // %7 = OpTypeFloat 32; %9 = OpConstant %7 1.0
        let module = with_types(&[0x0003_0016, 7, 32, 0x0004_002b, 7, 9, 0x3f80_0000]);
        assert_eq!(prune(&module).unwrap(), module);
    }
}
