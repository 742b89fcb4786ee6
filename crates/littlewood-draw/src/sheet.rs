//! The paper: how wide a figure is, and where its parts stand on it.

use crate::clip;
use crate::error::DrawError;
use crate::figure::{Figure, Key, Label, Layer, Mark, Panel, PanelFrame, PlotAxis, View, tilted};
use crate::letters::width;
use crate::primitives::Point;
use crate::stroke::SMALL;

/// Narrowest print, in millimetres.
pub const LEAST_WIDTH_MM: f64 = 60.0;
/// Widest.
pub const MOST_WIDTH_MM: f64 = 420.0;

/// Points to a pixel of a drawing: in print letters are smaller than on a screen, those of ticks 7
/// points.
pub const PRINT_POINTS: f64 = 7.0 / SMALL;
/// Points to a millimetre.
pub const POINTS_TO_A_MM: f64 = 72.0 / 25.4;

/// Room on the left and on the right of the panels.
const LEFT: f64 = 6.0;
const RIGHT: f64 = 22.0;
/// Room above the panels, and below.
const ABOVE: f64 = 12.0;
const BELOW: f64 = 6.0;

/// Where the key begins.
const KEYS_LEFT: f64 = 68.0;
/// Length of the sample of a key, and the room after its text.
const SAMPLE: f64 = 32.0;
const GAP: f64 = 20.0;
/// Height of a row of keys.
const ROW: f64 = 20.0;

/// Least width of panels that stand beside each other, and room between them.
const NARROWEST: f64 = 300.0;
const BESIDE: f64 = 14.0;

/// Panels are flatter on a narrow sheet, and not much higher on a wide one.
const FLATTEST: f64 = 0.7;
const HIGHEST: f64 = 1.15;

/// What marks mean, with marks of text: the lines of a key that have no place yet.
pub type Entries = Vec<(Mark, String)>;

/// A sheet.
#[derive(Clone, Copy, Debug)]
pub struct Sheet {
    /// Width in pixels.
    pub width: f64,
    /// The width for which heights are given.
    own: f64,
    print_mm: Option<f64>,
}

/// What is in a panel.
#[derive(Clone, Debug)]
pub struct Content {
    /// Name in the file of data.
    pub name: &'static str,
    /// To the right.
    pub x: PlotAxis,
    /// Upwards.
    pub y: PlotAxis,
    /// What is drawn, the lowest first.
    pub layers: Vec<Layer>,
    /// Texts.
    pub labels: Vec<Label>,
}

/// Those lines of a key whose mark is seen within the axes of some contents, the data turned by an
/// angle against them.
pub fn seen(entries: Entries, contents: &[Content], tilt: f64) -> Entries {
    let is_seen = |(mark, _): &(Mark, String)| {
        contents.iter().any(|content| {
            let mut layers = content.layers.iter();
            layers.any(|layer| is_sample(*mark, layer.mark) && content.shows(layer, tilt))
        })
    };
    entries.into_iter().filter(is_seen).collect()
}

impl Content {
    /// Whether something of a layer lies within the axes.
    fn shows(&self, layer: &Layer, tilt: f64) -> bool {
        let columns = [&self.x, &self.y].map(|axis| layer.series.column(&axis.column));
        let [Some(across), Some(up)] = columns else {
            return false;
        };
        let share = |row: &Vec<f64>| {
            let place = tilted(tilt, Point::new(row[across], row[up]));
            [self.x.share(place.x), self.y.share(place.y)]
        };
        let is_inside = |place: &[f64; 2]| place.iter().all(|share| (0.0..=1.0).contains(share));
        layer.series.pieces.iter().any(|piece| {
            let places: Vec<[f64; 2]> = piece.iter().map(share).collect();
            // An area may hold all of the axes.
            layer.mark.is_area() && !places.is_empty()
                || places.iter().any(is_inside)
                || matches!(layer.mark, Mark::Line(_))
                    && !clip::line(&places, [[0.0; 2], [1.0; 2]]).is_empty()
        })
    }
}

/// Whether a mark of a key is a sample of one that is drawn: lines have their width in common only
/// where it means something.
fn is_sample(key: Mark, drawn: Mark) -> bool {
    match (key, drawn) {
        (Mark::Line(key), Mark::Line(line) | Mark::Arrow(line)) => {
            key.colour == line.colour && key.dash == line.dash
        }
        (Mark::Line(key), Mark::Hoop(hoop)) => key.colour == hoop.rim.colour,
        (Mark::Hoop(_), Mark::Hoop(_)) => true,
        (key, drawn) => key == drawn,
    }
}

/// Refuses a width in print, in millimetres, beyond [`LEAST_WIDTH_MM`] and [`MOST_WIDTH_MM`].
///
/// # Errors
/// [`DrawError::Width`].
pub fn check_width(mm: f64) -> Result<(), DrawError> {
    if (LEAST_WIDTH_MM..=MOST_WIDTH_MM).contains(&mm) {
        Ok(())
    } else {
        Err(DrawError::Width {
            mm,
            least: LEAST_WIDTH_MM,
            most: MOST_WIDTH_MM,
        })
    }
}

impl Sheet {
    /// A sheet of a width in print; as wide as the figure wants on a screen.
    ///
    /// # Errors
    /// [`DrawError::Width`].
    pub fn new(print_mm: Option<f64>, own: f64) -> Result<Self, DrawError> {
        let Some(mm) = print_mm else {
            return Ok(Self {
                width: own,
                own,
                print_mm,
            });
        };
        check_width(mm)?;
        Ok(Self {
            width: mm * POINTS_TO_A_MM / PRINT_POINTS,
            own,
            print_mm,
        })
    }

    /// Height of a panel that has this height on a screen.
    pub fn height(&self, own: f64) -> f64 {
        libm::round(own * (self.width / self.own).clamp(FLATTEST, HIGHEST))
    }

    /// Left end and width of a panel from side to side.
    pub fn span(&self) -> [f64; 2] {
        [LEFT, self.width - LEFT - RIGHT]
    }

    /// The frames of two panels of a height, with so much room above each: beside each other, or
    /// on a narrow sheet one below the other.
    pub fn frames(&self, above_first: f64, above_second: f64, height: f64) -> [PanelFrame; 2] {
        let [left, inner] = self.span();
        let each = 0.5 * (inner - BESIDE);
        if each < NARROWEST {
            let below = above_first + height + above_second;
            return [above_first, below].map(|top| PanelFrame {
                left,
                top,
                width: inner,
                height,
            });
        }
        let top = f64::max(above_first, above_second);
        [left, left + (each + BESIDE)].map(|left| PanelFrame {
            left,
            top,
            width: each,
            height,
        })
    }

    /// Keys in rows from a height downwards, in columns where it takes more than one row, and the
    /// height of all.
    pub fn keys(&self, entries: Entries, top: f64) -> (Vec<Key>, f64) {
        let widths: Vec<f64> = entries
            .iter()
            .map(|(_, text)| SAMPLE + width(text, SMALL) + GAP)
            .collect();
        let room = self.width - 10.0 + GAP;
        let all: f64 = widths.iter().sum();
        let widest = widths.iter().copied().fold(0.0, f64::max);
        let rows_from = |left: f64| {
            let fits = libm::floor((room - left) / widest) as usize;
            if left + all <= room {
                1
            } else {
                entries.len().div_ceil(fits.clamp(1, entries.len().max(1)))
            }
        };
        // Where that takes no more rows they begin with the axes.
        let is_indented =
            KEYS_LEFT + all.min(widest) <= room && rows_from(KEYS_LEFT) <= rows_from(10.0);
        let left = if is_indented { KEYS_LEFT } else { 10.0 };
        // As few columns as make the same number of rows.
        let rows = rows_from(left);
        let columns = entries.len().div_ceil(rows.max(1));
        let is_row = left + all <= room;
        let mut at = left;
        let mut keys = Vec::new();
        for (i, ((mark, text), wide)) in entries.into_iter().zip(widths).enumerate() {
            let place = if is_row {
                at += wide;
                [at - wide, top + 0.5 * ROW]
            } else {
                [
                    left + widest * (i % columns) as f64,
                    top + ROW * ((i / columns) as f64 + 0.5),
                ]
            };
            keys.push(Key {
                mark,
                text,
                at: place,
            });
        }
        let rows = if is_row {
            usize::from(!keys.is_empty())
        } else {
            rows
        };
        (keys, ROW * rows as f64)
    }

    /// A panel in a frame.
    pub fn panel(frame: PanelFrame, content: Content) -> Panel {
        Self::tilted(frame, content, 0.0)
    }

    /// A panel in a frame, the coordinates of its data turned by an angle against its axes.
    pub fn tilted(frame: PanelFrame, content: Content, tilt: f64) -> Panel {
        Self::framed(frame, content, true, tilt)
    }

    /// The same without axes.
    pub fn bare(frame: PanelFrame, content: Content, tilt: f64) -> Panel {
        Self::framed(frame, content, false, tilt)
    }

    fn framed(frame: PanelFrame, content: Content, axes: bool, tilt: f64) -> Panel {
        let Content {
            name,
            x,
            y,
            layers,
            labels,
        } = content;
        let view = View::Plane { x, y, axes, tilt };
        Panel {
            name,
            frame,
            view,
            layers,
            labels,
            image: None,
            keys: Vec::new(),
        }
    }

    /// A figure of one panel, so high on a screen, with its keys above it.
    pub fn plot(
        &self,
        name: &'static str,
        title: &str,
        caption: String,
        own_height: f64,
        content: Content,
        entries: Entries,
    ) -> Figure {
        let entries = seen(entries, core::slice::from_ref(&content), 0.0);
        let (keys, room) = self.keys(entries, 6.0);
        let [left, inner] = self.span();
        let height = self.height(own_height);
        let frame = PanelFrame {
            left,
            top: ABOVE + room,
            width: inner,
            height,
        };
        let mut panel = Self::panel(frame, content);
        panel.keys = keys;
        self.figure(
            name,
            title,
            caption,
            ABOVE + room + height + BELOW,
            vec![panel],
        )
    }

    /// A figure of panels.
    pub fn figure(
        &self,
        name: &'static str,
        title: &str,
        caption: String,
        height: f64,
        panels: Vec<Panel>,
    ) -> Figure {
        let title = title.to_owned();
        Figure {
            name,
            title,
            caption,
            width: self.width,
            height,
            print_mm: self.print_mm,
            panels,
            notes: Vec::new(),
        }
    }
}
