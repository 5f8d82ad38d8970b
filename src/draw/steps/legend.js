// The legend, drawn in the same styles as the picture.

function drawLegend(list) {
  for (const style of trace.styles.filter(({ meaning }) => meaning)) {
    const item = document.createElement("li");
    const sample = document.createElement("canvas");
    [sample.width, sample.height] = [68, 36];
    const painter = Object.create(View.prototype);
    Object.assign(painter, { context: sample.getContext("2d"), spacing: 1, scale: 100 });
    painter.context.scale(2, 2);
    if (style.fill || style.hatch) {
      painter.stroke(style, [[3, 15], [31, 15], [17, 3]], true);
    } else if (["legal", "illegal"].includes(style.name)) {
      painter.context.arc(17, 9, 7.5, 0, 2 * Math.PI);
      painter.paint(style);
    } else {
      painter.stroke(style, [[3, 9], [31, 9]]);
    }
    item.append(sample, style.meaning);
    list.append(item);
  }
}
