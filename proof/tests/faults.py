"""Plants faults in the checker, one at a time, and sees that each breaks the proof.

    python3 faults.py [NUMBER ...]

Run proof/run first. A fault is a text that occurs once in a file, and the wrong text for it. The faulty checker must
still be a program (Check.v compiles), and some file of the proof must fail. Each fault makes the checker accept more
than it should, or takes other triangles for inside; faults that make it refuse more are not for a proof of soundness to
find.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

PROOF = pathlib.Path(__file__).resolve().parent.parent
ORDER = "Check Place Laid Border Pieces Course Tiling Values Cover Walk Unique Domain Main".split()

STEP = "same a (left_end (item_side i)) && same b (right_end (item_side i)) && legal rule (mark_ab m) c i"
NEXT = "same b (left_end (item_side j)) && same c (right_end (item_side j)) && legal rule (mark_bc m) a j"
FAULTS = [
    ("Check", "flat triangles", "if Z.ltb 0 (zorient a b c) then", "if Z.leb 0 (zorient a b c) then"),
    ("Check", "the area has a wrong sign",
     "(zx b - zx a) * (zy c - zy a) - (zy b", "(zx b - zx a) * (zy c - zy a) + (zy b"),
    ("Check", "the circle has a wrong term", "(ax * by_ - ay * bx)", "(ax * by_ - ay * cx)"),
    ("Check", "points of one x are equal", "Eq => Z.compare (zy a) (zy b) | c => c", "Eq => Eq | c => c"),
    ("Check", "a lower side may begin elsewhere", STEP, STEP.replace("same a (left_end (item_side i)) && ", "")),
    ("Check", "a lower side may end elsewhere", STEP, STEP.replace("same b (right_end (item_side i)) && ", "")),
    ("Check", "the first lower side is not tested", STEP, STEP.replace(" && legal rule (mark_ab m) c i", "")),
    ("Check", "the second lower side may begin elsewhere",
     NEXT, NEXT.replace("same b (left_end (item_side j)) && ", "")),
    ("Check", "the second lower side may end elsewhere",
     NEXT, NEXT.replace("same c (right_end (item_side j)) && ", "")),
    ("Check", "the second lower side is not tested", NEXT, NEXT.replace(" && legal rule (mark_bc m) a j", "")),
    ("Check", "the second lower side is tested with a wrong corner", NEXT, NEXT.replace("a j", "b j")),
    ("Check", "the front may go back", "if before a c then\n", "if before a b then\n"),
    ("Check", "the new point may be anywhere", "if before c b then\n", "if before b c then\n"),
    ("Check", "the corner below a new side is wrong", "Item (ZSide c b) (Some a)", "Item (ZSide c b) (Some b)"),
    ("Check", "points in circles", "| Gt => false\n", "| Gt => true\n"),
    ("Check", "ties are free", "Eq => negb rule || tie_is_right a b c d", "Eq => true"),
    ("Check", "a tie looks at three corners", "zfirst f c && zfirst f d", "zfirst f c"),
    ("Check", "the lower of two corners is first", "Eq => Z.leb (zy b) (zy a)", "Eq => Z.leb (zy a) (zy b)"),
    ("Check", "sides with a mark below are not tested",
     "else if marked i then false\n", "else if marked i then true\n"),
    ("Check", "marks are lost", "if mark then item_side i :: l else l", "l"),
    ("Check", "the border may go back", "  before (left_end s) (right_end s) &&\n", "  true &&\n"),
    ("Check", "the border may have gaps", "    same (right_end s) (left_end t) &&\n", "    true &&\n"),
    ("Check", "the border may have dents",
     "Z.leb 0 (sign * zorient (left_end s) (right_end s) (right_end t)) && chain", "chain"),
    ("Check", "the upper border turns the wrong way", "chain (-1) t h", "chain 1 t h"),
    ("Check", "the borders begin apart", " && same (left_end f) (left_end t)", ""),
    ("Check", "the borders end apart", " && same (right_end l) (last_end t h)", ""),
    ("Check", "the upper border may be anything", "      && chain (-1) t h && same", "      && same"),
    ("Check", "the lower border may go back", "  if before (left_end x) (right_end x) then\n", "  if true then\n"),
    ("Check", "the lower border may have gaps", "same (right_end s) (left_end t) && Z.leb", "Z.leb"),
    ("Check", "the lower border may have dents",
     "same (right_end s) (left_end t) && Z.leb 0 (zorient (left_end s) (right_end s) (right_end t))",
     "same (right_end s) (left_end t)"),
    ("Check", "the lower border begins where it did", "Some (x, l, State [] (i", "Some (f, l, State [] (i"),
    ("Check", "sides without a triangle", "all_covered front\n      && ", ""),
    ("Check", "points may be missing", "      && same_set_once compare_points (given c) (brought s)\n", "\n"),
    ("Check", "edges may be missing", "      && same_set compare_sides (split c) (marked_sides front (used s))\n", "\n"),
    ("Check", "edges may go through any points", "if inside a v b then pieces_of", "if true then pieces_of"),
    ("Check", "points beside an edge", "Z.eqb (zorient a b v) 0 && (before a v", "(before a v"),
    ("Check", "points beyond the end of an edge", "(before a v && before v b ||", "(before a v ||"),
    ("Check", "no edges", "if same (edge_from e) (edge_to e) then pieces r acc", "if true then pieces r acc"),
    ("Check", "points on no line",
     "if Z.eqb (zorient a b p) 0 then l else OffLine", "l"),
    ("Check", "points at no place", "if same a p then l else OnLine a p", "l"),
    ("Check", "triangles are none", "(open c) (seen_line c) false)", "(open c) (seen_line c) (is_empty c))"),
    ("Check", "points that wait are lost", "(low c) g p (fallen c)", "(low c) [] p (fallen c)"),
    ("Check", "pieces that wait are lost", "(low c) g p (fallen c)", "(low c) g [] (fallen c)"),
    ("Check", "sides that wait are lost", "(ahead s) b u (rises s)) (low c)", "(ahead s) b [] (rises s)) (low c)"),
    ("Check", "values rise unseen", "then l else Rise (item_side i) 0 (v - level i) :: l", "then l else l"),
    ("Check", "values rise by what is above alone", "Rise (item_side i) 0 (v - level i)", "Rise (item_side i) 0 v"),
    ("Check", "the value of the triangle below is lost", "Item (ZSide a c) (Some b) (mark_ca m) v w :: r')",
     "Item (ZSide a c) (Some b) (mark_ca m) 0 w :: r')"),
    ("Check", "edges to the left count as edges to the right",
     "else Rise (ZSide b a) n 1", "else Rise (ZSide b a) n (-1)"),
    ("Check", "the last side alone must balance",
     "| _ => fits sum && balanced fits y (rise y) r", "| _ => balanced fits y (rise y) r"),
    ("Check", "nonzero is taken for even-odd",
     "all_balanced (Z.eqb 0) rs", "all_balanced Z.even rs"),
    ("Check", "values by even-odd are not compared",
     "| EvenOdd => all_balanced Z.even rs", "| EvenOdd => true"),
    ("Check", "values outside are free", "last_rises judge r (add_rise judge 0 (last_rings i) i acc)",
     "last_rises judge r acc"),
    ("Check", "values by polygons are not compared",
     "| Polygons _ => all_balanced Z.even rs && all", "| Polygons _ => all"),
    ("Check", "by polygons all edges are one ring", "falls edge_ring es acc", "falls one_ring es acc"),
    ("Check", "edges bound nothing", "| EvenOdd | NonZero => falls one_ring es acc", "| EvenOdd | NonZero => acc"),
    ("Check", "edges after a line bound nothing", "| None => falls ring_of r acc", "| None => acc"),
    ("Check", "rises of all rings are added", "Eq => Z.compare (rise_ring x) (rise_ring y)", "Eq => Eq"),
    ("Check", "rings may be open", " && all_balanced Z.even open", ""),
    ("Check", "rings end at one point", "at_point (edge_from e) :: at_point (edge_to e) :: acc",
     "at_point (edge_from e) :: at_point (edge_from e) :: acc"),
    ("Check", "rings change unseen", "fold_left (fun l r => Rise (item_side i) r 1 :: l) rs l", "l"),
    ("Check", "rings change and nothing comes of it", "| Some m => fold_left (flip m) rs (beneath i)",
     "| Some m => beneath i"),
    ("Check", "rings of the second lower side come to the first one", "add_rise judge v (rings_bc t) j (rises s)",
     "add_rise judge v (rings_ab t) j (rises s)"),
    ("Check", "rings below the second lower side go on", "let w := enter judge (rings_ab t) i in",
     "let w := enter judge (rings_bc t) i in"),
    ("Check", "what is inside is not compared", "| Some _ => Bool.eqb (is_covered w) (negb (Z.eqb v 0))",
     "| Some _ => true"),
    ("Check", "what is inside is outside", "| Some _ => Bool.eqb (is_covered w) (negb (Z.eqb v 0))",
     "| Some _ => Bool.eqb (is_covered w) (Z.eqb v 0)"),
    ("Check", "what is beneath the front is lost", "Item (ZSide a c) (Some b) (mark_ca m) v w :: r')",
     "Item (ZSide a c) (Some b) (mark_ca m) v outside :: r')"),
    ("Rings", "two rings have one name", "Zneg p => p~1 end.\n", "Zneg p => p~0 end.\n"),
    ("Rings", "a ring that comes does not go", "let on := negb (has k (odd w)) in\n  fold_left", "let on := true in\n  fold_left"),
    ("Rings", "holes are inside", " && PM.is_empty (snd g).", "."),
    ("Rings", "polygons have holes alone", "negb (PM.is_empty (fst g)) && ", ""),
    ("Rings", "a hole is an outline", "if hole then (o, put on k h) else (put on k o, h) in\n  Around",
     "(put on k o, h) in\n  Around"),
    ("Rings", "polygons that cover are kept", "(put (is_cover g) p (covering w))", "(put true p (covering w))"),
    ("Rings", "the next polygon has the same place", "table_of (Pos.succ p) r (", "table_of p r ("),
    ("Rings", "a ring has one role", "((p, hole) :: roles m (key r)) m) l m.\nFixpoint", "[(p, hole)] m) l m.\nFixpoint"),
    ("Sort", "a point may be brought twice", "match compare x y with Lt => ascending y r | _ => false end",
     "match compare x y with Gt => false | _ => ascending y r end"),
    ("Sort", "equal lists may differ in length", "| _, _ => false", "| _, _ => true"),
    ("Sort", "the first list loses what it has alone", "apart l' m (x :: left) right", "apart l' m left right"),
    ("Sort", "the second list loses what it has alone", "beside m' (y :: right)", "beside m' right"),
    ("Sort", "merging loses an item", "merge up l1 t2 (y :: acc)", "merge up l1 t2 acc"),
    ("Sort", "different items are merged",
     "match compare x y with Eq => distinct r acc | _ => distinct r (x :: acc) end",
     "distinct r acc"),
]


def compiles(folder, module):
    # A proof that a fault keeps from ending is broken, too: after so many seconds of the processor, not of the clock.
    coqc = subprocess.run(["bash", "-c", f"ulimit -t 300; exec coqc -q {module}.v"], cwd=folder, capture_output=True,
                          check=False)
    return coqc.returncode == 0


def broken_file(module, right, wrong):
    """The file whose proof the fault breaks, or None."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for pattern in ("*.v", "*.vo"):
            for file in (PROOF / "build").glob(pattern):
                shutil.copy(file, folder)
        text = (folder / f"{module}.v").read_text()
        if text.count(right) != 1:
            sys.exit(f"{right!r} occurs {text.count(right)} times in {module}.v")
        (folder / f"{module}.v").write_text(text.replace(right, wrong))
        if module == "Check" and not compiles(folder, "Check"):
            sys.exit(f"with {wrong!r} the checker is no program")
        for file in ORDER[1:] if module == "Check" else [module, *ORDER]:
            if not compiles(folder, file):
                return file
    return None


def main(numbers):
    survivors = 0
    for number, (module, name, right, wrong) in enumerate(FAULTS, 1):
        if numbers and number not in numbers:
            continue
        file = broken_file(module, right, wrong)
        survivors += file is None
        print(f"{number:3} {name}: {'breaks ' + file + '.v' if file else 'NOT FOUND'}", flush=True)
    if survivors:
        sys.exit(f"{survivors} faults do not break the proof")


if __name__ == "__main__":
    main([int(n) for n in sys.argv[1:]])
