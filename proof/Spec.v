(* What a constrained Delaunay triangulation is, over the real numbers. README.md explains each line. *)
(* Version 2 *)
Require Import Reals List ZArith.
Import ListNotations.
Open Scope R_scope.

Record point := Point { X : R; Y : R }.
Definition edge : Type := point * point.
Definition triangle : Type := point * point * point.

(* Twice the area of a, b, c: positive if they turn left, 0 if they are on one line. *)
Definition orient (a b c : point) : R := (X b - X a) * (Y c - Y a) - (Y b - Y a) * (X c - X a).

Definition between (a b : point) (s : R) : point := Point (X a + s * (X b - X a)) (Y a + s * (Y b - Y a)).
Definition on_segment (q a b : point) : Prop := exists s, 0 <= s <= 1 /\ q = between a b s.

Definition in_interior (q : point) '((a, b, c) : triangle) : Prop :=
  0 < orient a b q /\ 0 < orient b c q /\ 0 < orient c a q.
Definition in_triangle (q : point) '((a, b, c) : triangle) : Prop :=
  0 <= orient a b q /\ 0 <= orient b c q /\ 0 <= orient c a q.
Definition corner (p : point) '((a, b, c) : triangle) : Prop := p = a \/ p = b \/ p = c.
Definition side (p q : point) '((a, b, c) : triangle) : Prop :=
  (p, q) = (a, b) \/ (p, q) = (b, c) \/ (p, q) = (c, a).

(* The convex hull of P: what satisfies each linear inequality that all of P satisfy. *)
Definition in_hull (P : list point) (q : point) : Prop :=
  forall u v w, (forall p, In p P -> u * X p + v * Y p <= w) -> u * X q + v * Y q <= w.

(* The square of the distance; strictly inside, and on, the circle through the corners. *)
Definition dist2 (o p : point) : R := (X p - X o) * (X p - X o) + (Y p - Y o) * (Y p - Y o).
Definition centre (o : point) '((a, b, c) : triangle) : Prop := dist2 o a = dist2 o b /\ dist2 o b = dist2 o c.
Definition in_circle (p : point) (t : triangle) : Prop :=
  exists o, centre o t /\ forall a, corner a t -> dist2 o p < dist2 o a.
Definition on_circle (p : point) (t : triangle) : Prop :=
  exists o, centre o t /\ forall a, corner a t -> dist2 o p = dist2 o a.

(* Segments ab and cd cross: each has its ends strictly on both sides of the other. *)
Definition cross (a b c d : point) : Prop :=
  orient a b c * orient a b d < 0 /\ orient c d a * orient c d b < 0.
Definition blocked (E : list edge) (q p : point) : Prop := exists a b, In (a, b) E /\ cross a b q p.

Record triangulation (P : list point) (E : list edge) (T : list triangle) : Prop := {
  turns_left : forall a b c, In (a, b, c) T -> 0 < orient a b c;
  corners_given : forall t p, In t T -> corner p t -> In p P;
  no_overlap : forall i j t u q, i <> j -> nth_error T i = Some t -> nth_error T j = Some u ->
    ~ (in_interior q t /\ in_interior q u);
  covers_hull : forall q, in_hull P q <-> exists t, In t T /\ in_triangle q t;
  all_corners : forall p, In p P -> exists t, In t T /\ corner p t;
  no_point_within : forall p t, In p P -> In t T -> in_triangle p t -> corner p t;
  edges_are_sides : forall a b q, In (a, b) E -> a <> b -> on_segment q a b ->
    exists t c d, In t T /\ side c d t /\ on_segment q c d /\ on_segment c a b /\ on_segment d a b;
  delaunay : forall t p q, In t T -> In p P -> in_circle p t -> in_interior q t -> blocked E q p
}.

Definition on_one_line (P : list point) : Prop :=
  forall a b c, In a P -> In b P -> In c P -> orient a b c = 0.

Definition constrained_delaunay (P : list point) (E : list edge) (T : list triangle) : Prop :=
  triangulation P E T \/ (on_one_line P /\ T = []).

(* The rule for points on one circle: each region of one circle is the fan from its first corner. *)
Definition first (a b : point) : Prop := X a < X b \/ (X a = X b /\ Y a > Y b).
Definition first_of (a : point) (l : list point) : Prop := forall b, In b l -> a = b \/ first a b.
Definition first_corner_rule (P : list point) (E : list edge) (T : list triangle) : Prop :=
  forall t a b c p q, In t T -> side a b t -> corner c t -> c <> a -> c <> b ->
    In p P -> on_circle p t -> orient a b p < 0 -> in_interior q t ->
    blocked E q p \/ first_of a [a; b; c; p] \/ first_of b [a; b; c; p].

Definition canonical (P : list point) (E : list edge) (T : list triangle) : Prop :=
  constrained_delaunay P E T /\ first_corner_rule P E T.

(* The same points, the same edges in any direction, the same triangles wherever each begins. *)
Definition same_points (P Q : list point) : Prop := forall p, In p P <-> In p Q.
Definition same_edges (E F : list edge) : Prop :=
  forall a b, In (a, b) E \/ In (b, a) E <-> In (a, b) F \/ In (b, a) F.
Definition same_triangle (t u : triangle) : Prop := forall p, corner p t <-> corner p u.
Definition same_triangles (T U : list triangle) : Prop :=
  (forall t, In t T -> exists u, In u U /\ same_triangle t u) /\
  (forall u, In u U -> exists t, In t T /\ same_triangle t u).

(* Domains. How often the edges go round q: an edge that passes below q counts 1 if it runs to the right, and -1 if it
   runs to the left. An edge has the x of its left end, and not that of its right end. *)
Definition below_right (a b q : point) : Z :=
  if Rle_dec (X a) (X q) then if Rlt_dec (X q) (X b) then if Rlt_dec 0 (orient a b q) then 1 else 0 else 0 else 0.
Definition winding (E : list edge) (q : point) : Z :=
  fold_right (fun '(a, b) n => (below_right a b q - below_right b a q + n)%Z) 0%Z E.
Definition even_odd (E : list edge) (q : point) : Prop := Z.Odd (winding E q).
Definition nonzero (E : list edge) (q : point) : Prop := winding E q <> 0%Z.

(* A polygon by its outlines and its holes, each a list of edges: it covers what is inside an outline and in no hole. *)
Definition polygon : Type := list (list edge) * list (list edge).
Definition covers (q : point) '((outlines, holes) : polygon) : Prop :=
  (exists r, In r outlines /\ even_odd r q) /\ forall r, In r holes -> ~ even_odd r q.
Definition in_polygons (L : list polygon) (q : point) : Prop := exists p, In p L /\ covers q p.

(* The triangles of T that are in I are those inside, and no triangle is partly inside. *)
Definition interior (inside : point -> Prop) (T I : list triangle) : Prop :=
  incl I T /\ forall t q, In t T -> in_interior q t -> (In t I <-> inside q).
