//! Colours of numbers.

use crate::rgb::Rgb;

/// Viridis at equal steps.
const NODES: [u32; 33] = [
    0x440154, 0x470d60, 0x48186a, 0x482374, 0x472d7b, 0x453781, 0x424086, 0x3e4989, 0x3b528b,
    0x375b8d, 0x33638d, 0x2f6b8e, 0x2c728e, 0x297a8e, 0x26828e, 0x23898e, 0x21918c, 0x1f978b,
    0x1f9f88, 0x21a685, 0x27ad81, 0x31b57b, 0x3dbc74, 0x4cc26c, 0x5cc863, 0x6ece58, 0x81d34d,
    0x95d840, 0xaadc32, 0xc0df25, 0xd5e21a, 0xeae51a, 0xfde725,
];

/// Colour of a fraction from 0 to 1 of a scale of numbers: viridis, which grows lighter throughout.
pub fn of_fraction(fraction: f64) -> Rgb {
    let place = fraction.clamp(0.0, 1.0) * (NODES.len() - 1) as f64;
    let before = (place as usize).min(NODES.len() - 2);
    let [a, b] = [before, before + 1].map(|node| Rgb::of_hex(NODES[node]));
    b.over(a, place - before as f64)
}
