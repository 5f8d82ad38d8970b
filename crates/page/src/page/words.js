// What the page says of an answer.

const number = (value) => value.toLocaleString("en");
const many = (count, one, more = `${one}s`) => `${number(count)} ${count === 1 ? one : more}`;

function summaryOf({ summary: { points, edges, triangles, stats } }) {
  const given = `${many(points, "point")}, ${many(edges, "edge")}`;
  const equal = stats?.duplicates ? ` (${many(stats.duplicates, "duplicate")})` : "";
  return stats ? `${given}${equal}: ${many(triangles, "triangle")}.` : `${given}.`;
}

function crossingsOf({ summary: { crossings, displacement, stats } }) {
  if (!crossings) {
    return "";
  }
  const cross = `${many(crossings, "pair")} of edges ${crossings === 1 ? "crosses" : "cross"}.`;
  if (!stats) {
    return `${cross} They have no triangulation, unless they are split.`;
  }
  const moved = displacement ? `moves an edge by at most ${displacement} units in the last place` : "moves no edge";
  return `${cross} The triangulation is that of their pieces; splitting ${moved}.`;
}

/** Rows of names and numbers: those that a newcomer asks for first. */
function countersOf({ summary: { stats } }) {
  if (!stats) {
    return [];
  }
  const count = stats.counters;
  const sum = (name) => ["orient2d", "in_circle"].reduce((total, test) => total + (count[`${test}_${name}`] ?? 0), 0);
  const time = (seconds) => `${(1000 * seconds).toFixed(1)} ms`;
  const made = Object.entries(count.made).filter(([, made]) => made);
  return [
    ["algorithm", stats.is_divided ? "divide and conquer" : "sweep"],
    ["initialization", time(stats.initialization)],
    ["sweeping", time(stats.sweeping)],
    ["finalization", time(stats.finalization)],
    ["vertices on the hull", number(stats.hull)],
    ["point events", number(count.point_events)],
    ["steps along the front", number(count.front_steps)],
    ["longest front", number(count.longest_front)],
    ["legalization: tests", number(count.legalization_tests)],
    ["legalization: flips", number(count.flips)],
    ["edges inserted", number(count.edges_inserted)],
    ["edges there already", number(count.edges_present)],
    ["triangles pierced", number(count.pierced)],
    ["signs by the filter", number(sum("filtered"))],
    ["signs by exact arithmetic", number(["integers", "expansions", "big", "own"].map(sum).reduce((a, b) => a + b))],
    ["cocircular tests", number(count.cocircular)],
    ...made.map(([cause, made]) => [`made: ${cause.replaceAll("_", " ")}`, number(made)]),
  ];
}
