//! Where everything of an animation is on paper, and how it moves. Lengths on paper are in millimetres, heights count downwards.

use std::fmt::Write as _;

use pounding_scene::{Link, Standing};
use pounding_text::{millimetres, short};

use super::{Film, LASTS, NAMESPACE};
use crate::figures::elevation;
use crate::page::markup::escaped;
use crate::sketch;

/// Width of a building; largest displacement; widest gap; largest height.
const WIDE: f64 = 30.0;
const SWAY: f64 = 9.0;
const GAP: f64 = 26.0;
const TALL: f64 = 58.0;
/// Free space beside the outer buildings and above the highest roof.
const MARGIN: f64 = 12.0;
const ABOVE: f64 = 5.0;
/// From the ground to the names, to the clock, and to the lower edge.
const NAMES: f64 = 4.5;
const CLOCK: f64 = 11.0;
const BELOW: f64 = 16.5;
/// The least part of the animation for which a mark of a touch is seen, from 0 to 100.
const SEEN: f64 = 2.0;
/// Most marks of one pair.
const MOST: usize = 60;
/// How far a link reaches into a building, and how far below its floor it is drawn.
const HELD: f64 = 4.0;
const UNDER: f64 = 1.6;
/// Longest name.
const LONGEST: usize = 20;

const STYLE: &str = "\
.film{--ink:#222;--soft:#5a5a5a;--fill:#e6ebf0;--hit:#d55e00;--link:#16a;--paper:#fff;font:3.2px Helvetica,Arial,'DejaVu Sans',sans-serif}
@media screen and (prefers-color-scheme:dark){.film{--ink:#e4e4e4;--soft:#a9a9a9;--fill:#2c363f;--hit:#ff9d5c;--link:#6bf;--paper:#181818}}
.film .p{fill:var(--paper)}.film .s{fill:var(--fill);stroke:var(--ink);stroke-width:.25}.film .f,.film .g{stroke:var(--ink);stroke-width:.9;fill:none}
.film .c{stroke:var(--soft);stroke-width:.4;fill:none}.film .l{stroke:var(--link);stroke-width:.7;fill:none}.film text{fill:var(--ink)}.film .h{fill:var(--hit)}
@media print,(prefers-reduced-motion:reduce){.film *{animation:none!important}}
";

/// A row on paper.
pub(super) struct Stage {
    /// Left side of every structure at rest.
    lefts: Vec<f64>,
    width: f64,
    ground: f64,
    /// Millimetres on paper for a metre of displacement, and for one of height.
    across: f64,
    up: f64,
}

/// A number on paper.
fn mm(length: f64) -> String {
    let rounded = (length * 100.0).round() / 100.0;
    // A negative zero loses its sign.
    format!("{}", rounded + 0.0)
}

impl Stage {
    pub(super) fn of(film: &Film<'_>) -> Self {
        let scene = film.simulation.scene();
        let floors = film.floors();
        let all = (0..floors.all().len()).filter(|floor| !floors.all()[*floor].is_wall());
        let heights = all.clone().map(|floor| elevation(floors, floor));
        let up = TALL / heights.fold(0.0, f64::max);
        let largest = all.flat_map(|floor| {
            let instants = film.instants();
            instants.map(move |(time, _)| film.displacement(floor, time).abs())
        });
        let largest = largest.fold(0.0, f64::max);
        let gaps: Vec<f64> = scene.contacts.iter().flatten().map(|one| one.gap_m).collect();
        let widest = gaps.iter().copied().fold(0.0, f64::max);
        let across = (SWAY / largest).min(GAP / widest);
        let mut lefts = vec![MARGIN];
        for index in 1..scene.structures.len() {
            let gap = gaps.get(index - 1).copied().unwrap_or(0.0);
            lefts.push(lefts[index - 1] + WIDE + across * gap);
        }
        Self {
            width: lefts[lefts.len() - 1] + WIDE + MARGIN,
            lefts,
            ground: ABOVE + TALL,
            across,
            up,
        }
    }

    /// How many times larger displacements are than heights.
    pub(super) fn exaggeration(&self) -> f64 {
        self.across / self.up
    }

    fn height(&self, film: &Film<'_>, floor: usize) -> f64 {
        self.ground - self.up * elevation(film.floors(), floor)
    }

    /// The picture.
    pub(super) fn svg(&self, film: &Film<'_>, caption: &str) -> String {
        let mut style = String::from(STYLE);
        let mut body = String::new();
        for structure in 0..self.lefts.len() {
            self.structure(film, structure, (&mut style, &mut body));
        }
        for (index, link) in film.simulation.scene().links.iter().enumerate() {
            self.link(film, (index, link), (&mut style, &mut body));
        }
        for floor in 0..film.floors().all().len() {
            self.marks(film, floor, (&mut style, &mut body));
        }
        self.clock(film, (&mut style, &mut body));
        let (width, height) = (self.width, self.ground + BELOW);
        format!(
            "<svg{NAMESPACE} class=\"film\" role=\"img\" viewBox=\"0 0 {w} {h}\" width=\"{}\" height=\"{}\" \
             aria-label=\"{}\">\n<style>\n{style}</style>\n<rect class=\"p\" width=\"{w}\" height=\"{h}\"/>\n{body}</svg>\n",
            mm(5.0 * width),
            mm(5.0 * height),
            escaped(caption),
            w = mm(width),
            h = mm(height),
        )
    }

    /// A structure with its name: every storey is sheared by its drift.
    fn structure(&self, film: &Film<'_>, structure: usize, (style, body): (&mut String, &mut String)) {
        let floors = film.floors();
        let is_wall = |floor: &&usize| floors.all()[**floor].is_wall();
        let left = self.lefts[structure];
        let own = floors.of_structure(structure);
        if own.iter().any(|floor| is_wall(&floor)) {
            let top = self.wall(film, own);
            let _ = writeln!(
                body,
                "<rect class=\"s\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
                mm(left),
                mm(top),
                mm(WIDE),
                mm(self.ground - top)
            );
        }
        let mut below = (self.ground, None);
        for floor in own.iter().filter(|floor| !is_wall(floor)) {
            let top = self.height(film, *floor);
            let (name, moved) = (format!("film-{floor}"), (below, (top, Some(*floor))));
            let _ = writeln!(
                body,
                "<g class=\"{name}\" transform=\"{}\"><path class=\"s\" d=\"M{l} {b}H{r}V{t}H{l}z\"/><path class=\"f\" d=\"M{l} {t}H{r}\"/></g>",
                self.moved(film, moved, film.at()),
                l = mm(left),
                r = mm(left + WIDE),
                b = mm(below.0),
                t = mm(top),
            );
            let frames = film
                .instants()
                .map(|(time, share)| format!("{}%{{transform:{}}}", mm(share), self.moved(film, moved, time)));
            animate(style, &name, &frames.collect::<String>());
            below = (top, Some(*floor));
        }
        let name = film.simulation.scene().structures[structure].name();
        let short: String = name.chars().take(LONGEST).collect();
        let _ = writeln!(
            body,
            "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
            mm(left + WIDE / 2.0),
            mm(self.ground + NAMES),
            escaped(&short)
        );
    }

    /// The top of a wall: the height of the highest floor that can touch it.
    fn wall(&self, film: &Film<'_>, own: &[usize]) -> f64 {
        let pairs = film.floors().facing().iter();
        let faced = pairs.filter_map(|pair| match (own.contains(&pair.left), own.contains(&pair.right)) {
            (true, _) => Some(pair.right),
            (_, true) => Some(pair.left),
            (false, false) => None,
        });
        let tops = faced.map(|floor| self.height(film, floor));
        tops.fold(self.ground, f64::min)
    }

    /// How a storey between two heights is moved at an instant: each with the floor that is there, the ground without one.
    fn moved(&self, film: &Film<'_>, (below, above): ((f64, Option<usize>), (f64, Option<usize>)), time: f64) -> String {
        let at = |floor: Option<usize>| floor.map_or(0.0, |floor| self.across * film.displacement(floor, time));
        let (bottom, top) = (at(below.1), at(above.1));
        let storey = below.0 - above.0;
        let shear = if storey > 0.0 { (bottom - top) / storey } else { 0.0 };
        let shear = (shear * 1e4).round() / 1e4 + 0.0;
        format!("matrix(1,0,{shear},1,{},0)", mm(bottom - shear * below.0))
    }

    /// A link: a line just below both floors, whose ends move with them.
    fn link(&self, film: &Film<'_>, (index, link): (usize, &Link), (style, body): (&mut String, &mut String)) {
        let Ok(ends) = link.ends(film.simulation.scene()) else {
            return;
        };
        let heights = sketch::heights(film.floors(), ends).map(|height| self.ground - self.up * height);
        let [left, right] = ends.map(|end| self.lefts[end.structure]);
        let is_inside = ends[0].structure == ends[1].structure;
        let from = if is_inside { left + HELD } else { left + WIDE - HELD };
        let to = if is_inside { right + WIDE - HELD } else { right + HELD };
        let below = |height: f64| if height < self.ground { height + UNDER } else { height };
        let moved = |time: f64| {
            let [one, other] = ends.map(|Standing { structure, floor }| {
                let floors = film.floors().of_structure(structure);
                let floor = floor.and_then(|floor| floors.get(floor));
                floor.map_or(0.0, |floor| self.across * film.displacement(*floor, time))
            });
            let stretch = ((1.0 + (other - one) / (to - from)) * 1e4).round() / 1e4;
            format!("matrix({stretch},0,0,1,{},0)", mm(one + (1.0 - stretch) * from))
        };
        let name = format!("film-l{index}");
        let _ = writeln!(
            body,
            "<path class=\"l {name}\" d=\"M{} {}L{} {}\" transform=\"{}\"/>",
            mm(from),
            mm(below(heights[0])),
            mm(to),
            mm(below(heights[1])),
            moved(film.at())
        );
        let frames = film
            .instants()
            .map(|(time, share)| format!("{}%{{transform:{}}}", mm(share), moved(time)));
        animate(style, &name, &frames.collect::<String>());
    }

    /// Marks of the pairs that touch at the right side of a floor, or of a wall at its left; above all buildings, and with the floor.
    fn marks(&self, film: &Film<'_>, floor: usize, (style, body): (&mut String, &mut String)) {
        let floors = film.floors();
        let is_wall = |floor: usize| floors.all()[floor].is_wall();
        let left = self.lefts[floors.all()[floor].structure];
        let (y, moved) = (self.height(film, floor), self.across * film.displacement(floor, film.at()));
        for (pair, facing) in floors.facing().iter().enumerate() {
            let x = if facing.left == floor && !is_wall(floor) {
                left + WIDE
            } else if facing.right == floor && is_wall(facing.left) {
                left
            } else {
                continue;
            };
            let touches = film.touches(pair);
            if touches.is_empty() || touches.len() > MOST {
                continue;
            }
            let (name, follows) = (format!("film-h{pair}"), format!("film-m{pair}"));
            let opacity = u8::from(pair == film.hardest.pair);
            let _ = writeln!(
                body,
                "<g class=\"{follows}\" transform=\"translate({},0)\"><circle class=\"h {name}\" cx=\"{}\" cy=\"{}\" r=\"1.7\" \
                 opacity=\"{opacity}\"/></g>",
                mm(moved),
                mm(x),
                mm(y)
            );
            let frames = film.instants().map(|(time, share)| {
                let moved = self.across * film.displacement(floor, time);
                format!("{}%{{transform:translate({}px,0)}}", mm(share), mm(moved))
            });
            animate(style, &follows, &frames.collect::<String>());
            animate(style, &name, &lit(&touches));
        }
    }

    /// The ground, and a clock below it.
    fn clock(&self, film: &Film<'_>, (style, body): (&mut String, &mut String)) {
        let (from, to) = (MARGIN, self.width - MARGIN);
        let y = self.ground + CLOCK;
        let share = (film.at() - film.from) / (film.to - film.from);
        let hardest = share * (to - from);
        let text = |x: f64, anchor: &str, text: &str| {
            format!(
                "<text x=\"{}\" y=\"{}\" text-anchor=\"{anchor}\">{text}</text>\n",
                mm(x),
                mm(y + 4.2)
            )
        };
        let _ = write!(
            body,
            "<path class=\"g\" d=\"M0 {g}H{w}\"/>\n<path class=\"c\" d=\"M{l} {y}H{r}M{h} {}v2.4\"/>\n\
             <circle class=\"film-t\" cx=\"{l}\" cy=\"{y}\" r=\"1.1\" style=\"fill:var(--ink)\" transform=\"translate({},0)\"/>\n",
            mm(y - 1.2),
            mm(hardest),
            g = mm(self.ground),
            w = mm(self.width),
            l = mm(from),
            r = mm(to),
            y = mm(y),
            h = mm(from + hardest),
        );
        body.push_str(&text(from, "start", &format!("{} s", short(film.from))));
        body.push_str(&text(to, "end", &format!("{} s", short(film.to))));
        let gaps = film.simulation.scene().contacts.iter().flatten();
        let gaps: Vec<String> = gaps.map(|one| millimetres(one.gap_m)).collect();
        let gaps = match &gaps[..] {
            [one] => format!("gap {one} mm"),
            several => format!("gaps {} mm", several.join(", ")),
        };
        if gaps.chars().count() <= 2 * LONGEST {
            body.push_str(&text(f64::midpoint(from, to), "middle", &gaps));
        }
        let frames = format!("0%{{transform:translate(0,0)}}100%{{transform:translate({}px,0)}}", mm(to - from));
        animate(style, "film-t", &frames);
    }
}

/// Adds keyframes, and who follows them.
fn animate(style: &mut String, name: &str, frames: &str) {
    let _ = writeln!(
        style,
        "@keyframes {name}{{{frames}}}.film .{name}{{animation:{name} {LASTS}s linear infinite}}"
    );
}

/// Keyframes of a mark that is lit while floors touch, and long enough to be seen.
fn lit(touches: &[[f64; 2]]) -> String {
    let mut joined: Vec<[f64; 2]> = Vec::new();
    for [start, end] in touches {
        let end = end.max(start + SEEN).min(100.0);
        match joined.last_mut() {
            Some(last) if *start <= last[1] => last[1] = last[1].max(end),
            _ => joined.push([*start, end]),
        }
    }
    // Opacity jumps: between two keyframes a hundredth of a per cent apart.
    let mut frames = String::from("0%{opacity:0}");
    for [start, end] in joined {
        let (before, after) = ((start - 0.01).max(0.0), (end + 0.01).min(100.0));
        let _ = write!(
            frames,
            "{}%{{opacity:0}}{}%,{}%{{opacity:1}}{}%{{opacity:0}}",
            mm(before),
            mm(start),
            mm(end),
            mm(after)
        );
    }
    frames + "100%{opacity:0}"
}

#[cfg(test)]
mod tests {
    use super::lit;

    #[test]
    fn reference_a_short_touch_is_seen_and_near_ones_are_one() {
        assert_eq!(
            lit(&[[10.0, 10.1], [11.5, 11.6], [99.5, 100.0]]),
            "0%{opacity:0}9.99%{opacity:0}10%,13.5%{opacity:1}13.51%{opacity:0}\
             99.49%{opacity:0}99.5%,100%{opacity:1}100%{opacity:0}100%{opacity:0}"
        );
    }
}
