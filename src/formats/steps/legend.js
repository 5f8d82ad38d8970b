// The legend, drawn with the same styles as the picture.

const LEGEND = [
  ["triangle", "triangle"], ["added", "new triangle"],
  ["front", "advancing front"], ["sweep", "sweep line"],
  ["input", "edge to come"], ["constraint", "constraint"],
  ["inserted", "inserted edge"], ["pierced", "pierced triangle"],
  ["upper", "upper pseudo-polygon"], ["lower", "lower pseudo-polygon"],
  ["legal", "test: legal"], ["illegal", "test: illegal"],
  ["gone", "swapped edge"], ["came", "edge that came"],
  ["ray", "side to P‑1, P‑2"], ["line", "front segment"],
];

function drawLegend(list) {
  const areas = ["triangle", "added", "pierced", "upper", "lower"];
  for (const [style, text] of LEGEND) {
    const item = document.createElement("li");
    const sample = document.createElement("canvas");
    [sample.width, sample.height] = [68, 36];
    const painter = Object.create(View.prototype);
    Object.assign(painter, { context: sample.getContext("2d"), spacing: 1, scale: 100 });
    painter.context.scale(2, 2);
    if (areas.includes(style)) {
      painter.stroke(style, [[3, 15], [31, 15], [17, 3]], true);
    } else if (["legal", "illegal"].includes(style)) {
      painter.context.arc(17, 9, 7.5, 0, 2 * Math.PI);
      painter.paint(STYLES[style]);
    } else {
      painter.stroke(style, [[3, 9], [31, 9]]);
    }
    item.append(sample, text);
    list.append(item);
  }
}
