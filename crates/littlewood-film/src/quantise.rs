//! The 256 colours of a GIF: fixed, because a film is drawn with few inks and their mixtures.

use std::collections::HashMap;

use crate::colour::{self, PAPER};
use littlewood_style::Rgb;

/// Index of the colour that lets the frame before shine through.
pub(crate) const TRANSPARENT: u8 = 0;

/// Steps from each ink to the paper.
const STEPS: u16 = 12;

/// Levels of red, green and blue of the colours for all other mixtures; fewer where there are more
/// inks.
const LEVELS: [u16; 3] = [5, 6, 4];
const FEWER_LEVELS: [u16; 3] = [4, 5, 3];

/// Maps colours to the nearest of 255.
#[derive(Debug)]
pub(crate) struct Quantiser {
    /// The colours; number 0 is not used.
    colours: Vec<Rgb>,
    known: HashMap<Rgb, u8>,
}

impl Quantiser {
    /// For films with impulses or energies, or without, and with lanes, or without.
    pub(crate) fn new(with_energies: bool, with_lanes: bool) -> Self {
        let mut colours: Vec<Rgb> = vec![PAPER];
        let mut add = |colour: Rgb| {
            if !colours[1..].contains(&colour) && colours.len() < 256 {
                colours.push(colour);
            }
        };
        let inks = colour::all(with_energies, with_lanes);
        let levels = if with_energies || with_lanes {
            FEWER_LEVELS
        } else {
            LEVELS
        };
        inks.iter().copied().for_each(&mut add);
        for step in 1..STEPS {
            for ink in &inks {
                let mix = |i: usize| {
                    let (ink, paper) = (u16::from(ink.0[i]), u16::from(PAPER.0[i]));
                    ((ink * (STEPS - step) + paper * step + STEPS / 2) / STEPS) as u8
                };
                add(Rgb([mix(0), mix(1), mix(2)]));
            }
        }
        for r in 0..levels[0] {
            for g in 0..levels[1] {
                for b in 0..levels[2] {
                    let level = |value: u16, i: usize| (value * 255 / (levels[i] - 1)) as u8;
                    add(Rgb([level(r, 0), level(g, 1), level(b, 2)]));
                }
            }
        }
        colours.resize(256, PAPER);
        Self {
            colours,
            known: HashMap::new(),
        }
    }

    /// The colours one after the other.
    pub(crate) fn table(&self) -> Vec<u8> {
        self.colours.iter().flat_map(|colour| colour.0).collect()
    }

    /// Index of the nearest colour.
    pub(crate) fn index(&mut self, colour: Rgb) -> u8 {
        let Self { colours, known } = self;
        *known
            .entry(colour)
            .or_insert_with(|| nearest(&colours[1..], colour) + 1)
    }
}

fn nearest(colours: &[Rgb], colour: Rgb) -> u8 {
    let mut best = (u32::MAX, 0);
    for (index, candidate) in colours.iter().enumerate() {
        // The eye sees differences of green best and of blue least.
        let distance: u32 = [(0, 3), (1, 6), (2, 1)]
            .into_iter()
            .map(|(i, weight)| weight * u32::from(candidate.0[i].abs_diff(colour.0[i])).pow(2))
            .sum();
        if distance < best.0 {
            best = (distance, index as u8);
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inks_are_kept_and_mixtures_are_near() {
        for with_energies in [false, true] {
            for with_lanes in [false, true] {
                inks_are_kept(with_energies, with_lanes);
            }
        }
    }

    fn inks_are_kept(with_energies: bool, with_lanes: bool) {
        let mut quantiser = Quantiser::new(with_energies, with_lanes);
        assert_eq!(quantiser.table().len(), 768);
        for ink in colour::all(with_energies, with_lanes) {
            let index = quantiser.index(ink);
            assert!(index != TRANSPARENT);
            assert_eq!(quantiser.colours[usize::from(index)], ink);
            for part in 0..=8_u16 {
                let mixture = [0, 1, 2].map(|i| {
                    ((u16::from(ink.0[i]) * part + u16::from(PAPER.0[i]) * (8 - part)) / 8) as u8
                });
                let index = quantiser.index(Rgb(mixture));
                let found = quantiser.colours[usize::from(index)];
                assert!(
                    (0..3).all(|i| found.0[i].abs_diff(mixture[i]) <= 18),
                    "{mixture:?} {found:?}"
                );
            }
        }
    }
}
