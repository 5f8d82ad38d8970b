(* The checker, a program over integers. certificate.md explains the format. Every loop is a tail call. The certificate is
   read once, record by record.

   The triangles come from below: each is laid on the upper border, the front, of those before it. A triangle with one
   lower side brings a new point to the front; one with two lower sides takes a point off it. So a side has both its
   triangles at hand when the upper one comes, and no side is ever searched for. *)
Require Import ZArith List Bool.
Require Import Sort Rings.
Import ListNotations.
Open Scope Z_scope.

Record zpoint := ZPoint { zx : Z; zy : Z }.

Definition zorient (a b c : zpoint) : Z :=
  (zx b - zx a) * (zy c - zy a) - (zy b - zy a) * (zx c - zx a).

(* Positive if p is strictly inside the circle through a, b, c, which turn left. *)
Definition zcircle (a b c p : zpoint) : Z :=
  let ax := zx a - zx p in let ay := zy a - zy p in
  let bx := zx b - zx p in let by_ := zy b - zy p in
  let cx := zx c - zx p in let cy := zy c - zy p in
  (ax * ax + ay * ay) * (bx * cy - by_ * cx)
  + (bx * bx + by_ * by_) * (cx * ay - cy * ax)
  + (cx * cx + cy * cy) * (ax * by_ - ay * bx).

(* A point is before another one if it is left of it, or below it where both have one x. *)
Definition compare_points (a b : zpoint) : comparison :=
  match Z.compare (zx a) (zx b) with Eq => Z.compare (zy a) (zy b) | c => c end.
Definition before (a b : zpoint) : bool := match compare_points a b with Lt => true | _ => false end.
Definition same (a b : zpoint) : bool := match compare_points a b with Eq => true | _ => false end.

(* A side or a piece of an edge, from the end that is before the other one. *)
Record zside := ZSide { left_end : zpoint; right_end : zpoint }.
Definition compare_sides (s t : zside) : comparison :=
  match compare_points (left_end s) (left_end t) with
  | Eq => compare_points (right_end s) (right_end t)
  | c => c
  end.

(* The certificate. *)
Record zmarks := Marks { mark_ab : bool; mark_bc : bool; mark_ca : bool }.
(* By polygons the value says whether the triangle is inside, and the rings that change across its lower sides are named. *)
Record ztriangle := ZTriangle
  { corner_a : zpoint; corner_b : zpoint; corner_c : zpoint; marks : zmarks; value : Z;
    rings_ab : list Z; rings_bc : list Z }.
Inductive zdomain := Hull | EvenOdd | NonZero | Polygons (ps : list zpolygon).
Record zedge := ZEdge
  { edge_from : zpoint; edge_through : list zpoint; edge_to : zpoint; edge_ring : option Z }.
Inductive record :=
| NewPoint (p : zpoint)
| NewEdge (e : zedge)
| NewLower (s : zside)
| NewTriangle (t : ztriangle)
| Forget.
Record certificate := Certificate { domain : zdomain; records : list record }.

(* What a certificate is about: its points, edges and triangles. *)
Definition points_in (r : record) : list zpoint := match r with NewPoint p => [p] | _ => [] end.
Definition edges_in (r : record) : list zedge := match r with NewEdge e => [e] | _ => [] end.
Definition triangles_in (r : record) : list ztriangle := match r with NewTriangle t => [t] | _ => [] end.
Definition points (k : certificate) : list zpoint := flat_map points_in (records k).
Definition edges (k : certificate) : list zedge := flat_map edges_in (records k).
Definition triangles (k : certificate) : list ztriangle := flat_map triangles_in (records k).

(* A side of the front; of the triangle below it the third corner, its mark for the side, its value, and the rings and
   polygons around it. *)
Record item := Item { item_side : zside; below : option zpoint; marked : bool; level : Z; beneath : around }.

(* By how much the value rises from below a side to above it, for one ring. *)
Record zrise := Rise { rise_side : zside; rise_ring : Z; rise : Z }.
Definition compare_rises (x y : zrise) : comparison :=
  match compare_sides (rise_side x) (rise_side y) with
  | Eq => Z.compare (rise_ring x) (rise_ring y)
  | c => c
  end.

(* The front in two parts: what is left of the place where the last triangle came, nearest first; and the rest. *)
Record state := State
  { passed : list item; ahead : list item; brought : list zpoint; used : list zside; rises : list zrise }.

Fixpoint go_right (a : zpoint) (passed ahead : list item) : list item * list item :=
  match ahead with
  | [] => (passed, [])
  | i :: r => if same a (left_end (item_side i)) then (passed, ahead) else go_right a (i :: passed) r
  end.
Fixpoint go_left (a : zpoint) (passed ahead : list item) : list item * list item :=
  match passed with
  | [] => ([], ahead)
  | i :: r => if same a (left_end (item_side i)) then (r, i :: ahead) else go_left a r (i :: ahead)
  end.
Definition go (a : zpoint) (passed ahead : list item) : list item * list item :=
  match ahead with
  | [] => go_left a passed ahead
  | i :: _ => if before a (left_end (item_side i)) then go_left a passed ahead else go_right a passed ahead
  end.

(* The rule of the first corner, of four corners on one circle. *)
Definition zfirst (a b : zpoint) : bool :=
  match Z.compare (zx a) (zx b) with Lt => true | Gt => false | Eq => Z.leb (zy b) (zy a) end.
Definition tie_is_right (a b c d : zpoint) : bool :=
  let f := if zfirst a b then a else b in zfirst f c && zfirst f d.

(* Triangle a, b, c may lie above the side ab of the front. *)
Definition legal (rule mark : bool) (c : zpoint) (i : item) : bool :=
  match below i with
  | None => true
  | Some d =>
    if mark then marked i
    else if marked i then false
    else
      let a := left_end (item_side i) in let b := right_end (item_side i) in
      match Z.compare (zcircle a b c d) 0 with
      | Lt => true
      | Eq => negb rule || tie_is_right a b c d
      | Gt => false
      end
  end.

Definition use (mark : bool) (i : item) (l : list zside) : list zside := if mark then item_side i :: l else l.

(* What goes round a triangle above side i, across which these rings change, and whether its value says so. Of no
   polygons (judge is None) there is nothing to say. *)
Definition enter (judge : option table) (rs : list Z) (i : item) : around :=
  match judge with
  | None => beneath i
  | Some m => fold_left (flip m) rs (beneath i)
  end.
Definition told (judge : option table) (w : around) (v : Z) : bool :=
  match judge with
  | None => true
  | Some _ => Bool.eqb (is_covered w) (negb (Z.eqb v 0))
  end.

(* The rises across side i, to value v above it; by polygons, as the triangle above names them. *)
Definition add_rise (judge : option table) (v : Z) (rs : list Z) (i : item) (l : list zrise) : list zrise :=
  match judge with
  | None => if Z.eqb v (level i) then l else Rise (item_side i) 0 (v - level i) :: l
  | Some _ => fold_left (fun l r => Rise (item_side i) r 1 :: l) rs l
  end.

Definition step (rule : bool) (judge : option table) (t : ztriangle) (s : state) : option state :=
  let a := corner_a t in let b := corner_b t in let c := corner_c t in
  let m := marks t in let v := value t in
  if Z.ltb 0 (zorient a b c) then
    match go a (passed s) (ahead s) with
    | (l, i :: r) =>
      let w := enter judge (rings_ab t) i in
      if same a (left_end (item_side i)) && same b (right_end (item_side i)) && legal rule (mark_ab m) c i
        && told judge w v
      then
        if before c b then
          if before a c then
            Some (State l
              (Item (ZSide a c) (Some b) (mark_ca m) v w :: Item (ZSide c b) (Some a) (mark_bc m) v w :: r)
              (c :: brought s) (use (mark_ab m) i (used s)) (add_rise judge v (rings_ab t) i (rises s)))
          else None
        else
          match r with
          | j :: r' =>
            if same b (left_end (item_side j)) && same c (right_end (item_side j)) && legal rule (mark_bc m) a j then
              Some (State l (Item (ZSide a c) (Some b) (mark_ca m) v w :: r') (brought s)
                (use (mark_ab m) i (use (mark_bc m) j (used s)))
                (add_rise judge v (rings_ab t) i (add_rise judge v (rings_bc t) j (rises s))))
            else None
          | [] => None
          end
      else None
    | (_, []) => None
    end
  else None.

(* The border: sides that follow each other to the right, and never turn right (sign 1) or left (sign -1). *)
Fixpoint chain (sign : Z) (s : zside) (l : list zside) : bool :=
  before (left_end s) (right_end s) &&
  match l with
  | [] => true
  | t :: r =>
    same (right_end s) (left_end t) &&
    Z.leb 0 (sign * zorient (left_end s) (right_end s) (right_end t)) && chain sign t r
  end.
Fixpoint last_end (s : zside) (l : list zside) : zpoint :=
  match l with
  | [] => right_end s
  | t :: r => last_end t r
  end.
(* Another side of the lower hull, at its left end or its right end. *)
Definition first_item (s : zside) : item := Item s None false 0 outside.
Definition joins (s t : zside) : bool :=
  same (right_end s) (left_end t) && Z.leb 0 (zorient (left_end s) (right_end s) (right_end t)).
Definition lengthen (x : zside) (low : option (zside * zside)) (s : state) : option (zside * zside * state) :=
  if before (left_end x) (right_end x) then
    let i := first_item x in
    match low with
    | None =>
      Some (x, x, State (passed s) (i :: ahead s) (left_end x :: right_end x :: brought s) (used s) (rises s))
    | Some (f, l) =>
      if joins x f then
        Some (x, l, State [] (i :: rev_append (passed s) (ahead s)) (left_end x :: brought s) (used s) (rises s))
      else if joins l x then
        Some (f, x, State (rev_append (ahead s) (passed s)) [i] (right_end x :: brought s) (used s) (rises s))
      else None
    end
  else None.

(* The pieces of an edge: each point that it passes lies between the one before and the end. *)
Definition piece (a b : zpoint) : zside := if before a b then ZSide a b else ZSide b a.
Definition inside (a v b : zpoint) : bool :=
  Z.eqb (zorient a b v) 0 && (before a v && before v b || before b v && before v a).
Fixpoint pieces_of (a : zpoint) (through : list zpoint) (b : zpoint) (acc : list zside) : option (list zside) :=
  match through with
  | [] => Some (piece a b :: acc)
  | v :: r => if inside a v b then pieces_of v r b (piece a v :: acc) else None
  end.
Fixpoint pieces (es : list zedge) (acc : list zside) : option (list zside) :=
  match es with
  | [] => Some acc
  | e :: r =>
    if same (edge_from e) (edge_to e) then pieces r acc
    else match pieces_of (edge_from e) (edge_through e) (edge_to e) acc with
         | Some acc' => pieces r acc'
         | None => None
         end
  end.

(* Whether all points so far are on one line, and which. *)
Inductive line := NoPoint | OnePlace (a : zpoint) | OnLine (a b : zpoint) | OffLine.
Definition see (p : zpoint) (l : line) : line :=
  match l with
  | NoPoint => OnePlace p
  | OnePlace a => if same a p then l else OnLine a p
  | OnLine a b => if Z.eqb (zorient a b p) 0 then l else OffLine
  | OffLine => OffLine
  end.

Fixpoint map_items {A} (f : item -> A) (l : list item) (acc : list A) : list A :=
  match l with
  | [] => acc
  | i :: r => map_items f r (f i :: acc)
  end.
Fixpoint marked_sides (l : list item) (acc : list zside) : list zside :=
  match l with
  | [] => acc
  | i :: r => marked_sides r (use (marked i) i acc)
  end.

(* Each side of the front has a triangle below. *)
Fixpoint all_covered (l : list item) : bool :=
  match l with
  | [] => true
  | i :: r => match below i with Some _ => all_covered r | None => false end
  end.

(* For each ring the value rises from a triangle to the next one by the number of its edges along the side, to the right
   less to the left. Outside it is 0. For even-odd and for polygons, odd and even are all that counts. By even-odd and
   nonzero all edges are one ring.

   By polygons the value above a second lower side is not compared with what is below it: where rings are closed, it
   must be right. On the border the rings that change are those that are left. *)
Definition ring_of_key (k : positive) : Z := match k with xH => 0 | xO p => Zpos p | xI p => Zneg p end.
Definition last_rings (i : item) : list Z := PM.fold (fun k _ l => ring_of_key k :: l) (odd (beneath i)) [].
Fixpoint last_rises (judge : option table) (l : list item) (acc : list zrise) : list zrise :=
  match l with
  | [] => acc
  | i :: r => last_rises judge r (add_rise judge 0 (last_rings i) i acc)
  end.
Definition one_ring (e : zedge) : option Z := Some 0.
Definition fall (n : Z) (a b : zpoint) : zrise :=
  if before a b then Rise (ZSide a b) n (-1) else Rise (ZSide b a) n 1.
Fixpoint falls_of (n : Z) (a : zpoint) (through : list zpoint) (b : zpoint) (acc : list zrise) : list zrise :=
  match through with
  | [] => fall n a b :: acc
  | v :: r => falls_of n v r b (fall n a v :: acc)
  end.
Fixpoint falls (ring_of : zedge -> option Z) (es : list zedge) (acc : list zrise) : list zrise :=
  match es with
  | [] => acc
  | e :: r =>
    match ring_of e with
    | None => falls ring_of r acc
    | Some n =>
      if same (edge_from e) (edge_to e) then falls ring_of r acc
      else falls ring_of r (falls_of n (edge_from e) (edge_through e) (edge_to e) acc)
    end
  end.
Fixpoint balanced (fits : Z -> bool) (x : zrise) (sum : Z) (l : list zrise) : bool :=
  match l with
  | [] => fits sum
  | y :: r =>
    match compare_rises x y with
    | Eq => balanced fits x (sum + rise y) r
    | _ => fits sum && balanced fits y (rise y) r
    end
  end.
Definition all_balanced (fits : Z -> bool) (l : list zrise) : bool :=
  match sort compare_rises l with
  | [] => true
  | x :: r => balanced fits x (rise x) r
  end.
(* The ends of the edges of each ring, each as a side of no length. A ring is closed if they are even everywhere. *)
Fixpoint ends (es : list zedge) (acc : list zrise) : list zrise :=
  match es with
  | [] => acc
  | e :: r =>
    match edge_ring e with
    | None => ends r acc
    | Some n =>
      let at_point p := Rise (ZSide p p) n 1 in ends r (at_point (edge_from e) :: at_point (edge_to e) :: acc)
    end
  end.
Definition falls_in (d : zdomain) (es : list zedge) (acc : list zrise) : list zrise :=
  match d with
  | Hull => acc
  | EvenOdd | NonZero => falls one_ring es acc
  | Polygons _ => falls edge_ring es acc
  end.
Definition ends_in (d : zdomain) (es : list zedge) (acc : list zrise) : list zrise :=
  match d with
  | Polygons _ => ends es acc
  | _ => acc
  end.
Definition values_right (d : zdomain) (rs open : list zrise) : bool :=
  match d with
  | Hull => true
  | EvenOdd => all_balanced Z.even rs
  | NonZero => all_balanced (Z.eqb 0) rs
  | Polygons _ => all_balanced Z.even rs && all_balanced Z.even open
  end.

(* What is inside by its value. *)
Definition inside_by (d : zdomain) (t : ztriangle) : bool :=
  match d with
  | Hull => true
  | EvenOdd => Z.odd (value t)
  | NonZero | Polygons _ => negb (Z.eqb (value t) 0)
  end.

Definition judge_of (d : zdomain) : option table :=
  match d with
  | Polygons ps => Some (table_of 1 ps (PM.empty _))
  | _ => None
  end.

(* The checker after some records. Points that are given and brought, and pieces of edges that are given and used, wait for
   each other until they are forgotten together. *)
Record course := Course
  { laying : state; low : option (zside * zside); given : list zpoint; split : list zside;
    fallen : list zrise; open : list zrise; seen_line : line; is_empty : bool }.

Definition start : course := Course (State [] [] [] [] []) None [] [] [] [] NoPoint true.

Definition take (rule : bool) (d : zdomain) (judge : option table) (r : record) (c : course) : option course :=
  let s := laying c in
  match r with
  | NewPoint p =>
    Some (Course s (low c) (p :: given c) (split c) (fallen c) (open c) (see p (seen_line c)) (is_empty c))
  | NewEdge e =>
    match pieces [e] (split c) with
    | Some ps =>
      Some (Course s (low c) (given c) ps (falls_in d [e] (fallen c)) (ends_in d [e] (open c)) (seen_line c) (is_empty c))
    | None => None
    end
  | NewLower x =>
    match lengthen x (low c) s with
    | Some (f, l, s') =>
      Some (Course s' (Some (f, l)) (given c) (split c) (fallen c) (open c) (seen_line c) (is_empty c))
    | None => None
    end
  | NewTriangle t =>
    match step rule judge t s with
    | Some s' => Some (Course s' (low c) (given c) (split c) (fallen c) (open c) (seen_line c) false)
    | None => None
    end
  | Forget =>
    match judge with
    | Some _ => Some c (* The proof for polygons looks at all points that were brought. *)
    | None =>
      let (g, b) := cancel compare_points (given c) (brought s) in
      let (p, u) := cancel compare_sides (split c) (used s) in
      Some (Course (State (passed s) (ahead s) b u (rises s)) (low c) g p (fallen c) (open c) (seen_line c) (is_empty c))
    end
  end.

Definition finish (d : zdomain) (judge : option table) (c : course) : bool :=
  if is_empty c then match seen_line c with OffLine => false | _ => true end
  else
    let s := laying c in
    let front := rev_append (passed s) (ahead s) in
    match low c, rev_append (map_items item_side front []) [] with
    | Some (f, l), t :: h =>
      all_covered front
      && chain (-1) t h && same (left_end f) (left_end t) && same (right_end l) (last_end t h)
      && same_set_once compare_points (given c) (brought s)
      && same_set compare_sides (split c) (marked_sides front (used s))
      && values_right d (rev_append (fallen c) (last_rises judge front (rises s))) (open c)
    | _, _ => false
    end.

Fixpoint run (rule : bool) (d : zdomain) (judge : option table) (rs : list record) (c : course) : option course :=
  match rs with
  | [] => Some c
  | r :: rest => match take rule d judge r c with Some c' => run rule d judge rest c' | None => None end
  end.

Definition check (rule : bool) (k : certificate) : bool :=
  let judge := judge_of (domain k) in
  match run rule (domain k) judge (records k) start with
  | Some c => finish (domain k) judge c
  | None => false
  end.
