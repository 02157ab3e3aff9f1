//! Removes source text and line numbers from a SPIR-V module (SPIR-V specification 1.3, sections 2.3 and 3.32).
//!
//! Without spirv-opt, rust-gpu keeps them: whole files of `core` per module, under the builder's own paths.
//! Names of variables and functions stay, for legible WGSL.

use anyhow::{Result, ensure};

/// `OpSourceContinued`, `OpSource`, `OpSourceExtension`, `OpString`, `OpLine`, `OpNoLine`, `OpModuleProcessed`.
const DEBUG_OPCODES: [u32; 7] = [2, 3, 4, 7, 8, 317, 330];

const MAGIC: u32 = 0x0723_0203;
const HEADER_WORDS: usize = 5;

/// The module `spirv` (little-endian words) without the instructions that only serve debuggers.
///
/// # Errors
/// `spirv` is not a SPIR-V module, or an instruction reaches beyond its end.
pub fn strip(spirv: &[u8]) -> Result<Vec<u8>> {
    let (header, instructions) = split(spirv)?;
    let kept = instructions.iter().filter(|words| !DEBUG_OPCODES.contains(&opcode(words)));
    Ok(join(&header, kept))
}

/// The words of a module: its header, then one slice of words per instruction.
///
/// # Errors
/// As [`strip`].
pub fn split(spirv: &[u8]) -> Result<(Vec<u32>, Vec<Vec<u32>>)> {
    let (chunks, rest) = spirv.as_chunks::<4>();
    ensure!(rest.is_empty() && chunks.len() >= HEADER_WORDS, "{} bytes are no SPIR-V module", spirv.len());
    let words: Vec<u32> = chunks.iter().map(|chunk| u32::from_le_bytes(*chunk)).collect();
    ensure!(words[0] == MAGIC, "not a SPIR-V module: {:08x} at its start", words[0]);
    let mut instructions = Vec::new();
    let mut at = HEADER_WORDS;
    while at < words.len() {
        let length = (words[at] >> 16) as usize;
        ensure!(length > 0 && at + length <= words.len(), "broken instruction at word {at}");
        instructions.push(words[at..at + length].to_vec());
        at += length;
    }
    Ok((words[..HEADER_WORDS].to_vec(), instructions))
}

/// The opposite of [`split`].
pub fn join<'a>(header: &'a [u32], instructions: impl Iterator<Item = &'a Vec<u32>>) -> Vec<u8> {
    header.iter().chain(instructions.flatten()).flat_map(|word| word.to_le_bytes()).collect()
}

/// The operation of one instruction.
pub fn opcode(words: &[u32]) -> u32 {
    words[0] & 0xffff
}

#[cfg(test)]
mod tests {
    use super::*;

    fn module(instructions: &[u32]) -> Vec<u8> {
        let header = [MAGIC, 0x0001_0300, 0, 9, 0];
        header.iter().chain(instructions).flat_map(|word| word.to_le_bytes()).collect()
    }

    #[test]
    fn lines_and_sources_go_and_all_else_stays() {
        let capability = [0x0002_0011, 1];
        let source = [0x0003_0003, 0, 0];
        let no_line = [0x0001_013d];
        let mixed = [&source[..], &capability, &no_line].concat();
        assert_eq!(strip(&module(&mixed)).unwrap(), module(&capability));
    }

    #[test]
    fn malformed_modules_are_errors() {
        assert!(strip(&[]).is_err());
        assert!(strip(&[0; 20]).is_err(), "wrong magic number");
        assert!(strip(&module(&[])[..19]).is_err(), "odd length");
        assert!(strip(&module(&[0x0002_0011])).is_err(), "reaches beyond the end");
        assert!(strip(&module(&[0x0000_0011])).is_err(), "length 0 would never end");
    }
}
