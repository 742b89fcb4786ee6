//! x
use littlewood::*;
use std::collections::BTreeMap;
struct Rng(u64);
impl Rng {
    fn u(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}
fn main() {
    let mut r = Rng(7);
    let mut found: BTreeMap<String, (usize, String)> = BTreeMap::new();
    let mut kinds: BTreeMap<String, (usize, String)> = BTreeMap::new();
    for _ in 0..60000 {
        let m = if r.u() < 0.5 { 0.4 * r.u() } else { 2.0 * r.u() };
        let mu = 0.3 + 1.2 * r.u();
        let part = if r.u() < 0.3 { 1.0 } else { r.u() };
        let e = if r.u() < 0.4 { 0.0 } else { r.u() };
        let q = |v: f64| (v * 100.0).round() / 100.0;
        let (m, mu, muk, e, th, rate, slip) = (
            q(m),
            q(mu),
            q(mu * part),
            q(e),
            q(6.28 * r.u() - 3.14),
            q(6.0 * r.u() - 3.0),
            q(4.0 * r.u() - 2.0),
        );
        let Ok(hoop) = Hoop::new(
            HoopParameters::new(m, 1.0, m)
                .with_friction(mu, muk)
                .with_restitution(e, RestitutionLaw::ALL[(r.u() * 3.0) as usize]),
        ) else {
            continue;
        };
        let slip = if r.u() < 0.3 { 0.0 } else { slip };
        let t = hoop
            .simulate(Start::at(th, rate).with_slip(slip), Limits::until(60.0).with_transitions(2000))
            .unwrap();
        for x in t.transitions() {
            if find_edge(BodyClass::Heavy, x.from, x.cause, x.to).is_none() || x.impact.is_some() {
                let key = format!("{:?} {} {:?}", x.from, x.cause, x.to);
                let text = format!(
                    "m {m} mu {mu} {muk} e {e} {:?} th {th} rate {rate} slip {slip} n {}",
                    hoop.restitution().unwrap().law(),
                    t.transitions().len()
                );
                let entry = found.entry(key).or_insert((0, text.clone()));
                entry.0 += 1;
                if text.len() < entry.1.len() {
                    entry.1 = text;
                }
            }
            if let Some(i) = x.impact {
                let text = format!(
                    "m {m} mu {mu} {muk} e {e} {:?} th {th} rate {rate} slip {slip}",
                    hoop.restitution().unwrap().law()
                );
                kinds.entry(format!("case {:?}", i.case)).or_insert((0, text)).0 += 1;
            }
        }
        let text = format!(
            "m {m} mu {mu} {muk} e {e} {:?} th {th} rate {rate} slip {slip} n {}",
            hoop.restitution().unwrap().law(),
            t.transitions().len()
        );
        kinds.entry(t.outcome().kind().to_string()).or_insert((0, text)).0 += 1;
    }
    for (k, (n, t)) in found {
        println!("{k}: {n}: {t}");
    }
    for (k, (n, t)) in kinds {
        println!("{k}: {n} {t}");
    }
}
