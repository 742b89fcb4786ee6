//! Classes of outcomes.

use littlewood::tables::Class;

use crate::rgb::Rgb;
use crate::theme::Theme;

/// Colour of a class of outcomes.
pub const fn of_class(class: Class, theme: Theme) -> Rgb {
    match class {
        Class::LeavesAtOnce => theme.pick(0x191b54, 0xe8d5ff),
        Class::LiftsOffLater => theme.pick(0xdf9a01, 0x795100),
        Class::RollsForever => theme.pick(0xbad0db, 0x00415b),
        Class::RepeatsForever => theme.pick(0x004844, 0x5dcbc1),
        Class::SlipsForever => theme.pick(0x6a2f12, 0xe7ac93),
        Class::InContact => theme.pick(0x74849b, 0x69798f),
        Class::ParticleAtPlane => theme.pick(0xb69ec9, 0x665177),
        Class::ParticleAtBottom => theme.pick(0x400f33, 0xffcfdc),
        Class::ParticleAtTop => theme.pick(0x686300, 0xa39b00),
        Class::Rests => theme.pick(0xb4d89a, 0x184413),
        Class::Painleve => theme.pick(0x000000, 0xffffff),
        Class::Unresolved => theme.pick(0x616161, 0x989898),
        Class::Invalid => theme.pick(0xe4e4e4, 0x292929),
        // The paper.
        Class::NotComputed => theme.pick(0xffffff, 0x14171d),
    }
}
