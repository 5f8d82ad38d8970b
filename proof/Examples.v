(* Small examples, right and wrong by the definitions of Spec.v. *)
Require Import Reals ZArith List Lra Lia.
Require Import Spec Rings Check Place Main.
Import ListNotations.
Open Scope R_scope.

(* A square, counterclockwise from its lower left corner, and its middle. *)
Definition a := Point 0 0.
Definition b := Point 2 0.
Definition c := Point 2 2.
Definition d := Point 0 2.
Definition m := Point 1 1.
Definition square := [a; b; c; d].
(* The two triangulations of the square. Corner d is the first: leftmost, and upper of two. *)
Definition fan := [(a, b, d); (d, b, c)].
Definition other := [(a, b, c); (a, c, d)].

(* A kite, wider than high, and its two triangulations. *)
Definition w := Point 0 0.
Definition s := Point 4 (-1).
Definition e := Point 8 0.
Definition n := Point 4 1.
Definition kite := [w; s; e; n].
Definition upright := [(s, e, n); (w, s, n)].
Definition level := [(w, s, e); (w, e, n)].

Ltac compute_points := unfold in_interior, in_triangle, cross, centre, orient, dist2, first, corner, side,
  a, b, c, d, m, w, s, e, n in *; cbn [X Y fst snd] in *.

(* Right: by the checker. *)
Definition za := ZPoint 0 0.
Definition zb := ZPoint 2 0.
Definition zc := ZPoint 2 2.
Definition zd := ZPoint 0 2.
Definition no := Marks false false false.

(* A certificate with its points first, then edges, the lower hull and triangles. *)
Fixpoint sides (l : list zpoint) : list record :=
  match l with
  | a :: ((b :: _) as r) => NewLower (ZSide a b) :: sides r
  | _ => []
  end.
Definition whole d ps es low ts : certificate :=
  Certificate d (map NewPoint ps ++ map NewEdge es ++ sides low ++ map NewTriangle ts).

Lemma placed x y : place 1 (ZPoint x y) = Point (IZR x) (IZR y).
Proof. unfold place; cbn; f_equal; ring. Qed.

Ltac by_checker rule k theorem :=
  let H := fresh in assert (H : check rule k = true) by (vm_compute; reflexivity);
  apply (theorem 1 Rlt_0_1) in H;
  unfold real_points, real_edges, real_triangles, points, edges, triangles, place_triangle, place_edge in H;
  cbn [map whole records sides flat_map app points_in edges_in triangles_in points edges triangles corner_a corner_b corner_c edge_from edge_to za zb zc zd] in H;
  unfold za, zb, zc, zd in H; rewrite ?placed in H; exact H.

Example fan_is_right : canonical square [] fan.
Proof.
  by_checker true (whole Hull [za; zb; zc; zd] [] [za; zb; zc] [ZTriangle za zb zd no 0 [] [];
    ZTriangle zd zb zc no 0 [] []])
    accepted_is_canonical.
Qed.

Example other_is_right : constrained_delaunay square [] other.
Proof.
  by_checker false (whole Hull [za; zb; zc; zd] [] [za; zb; zc] [ZTriangle za zb zc no 0 [] [];
    ZTriangle za zc zd no 0 [] []])
    (fun u p => accepted_is_constrained_delaunay u p false).
Qed.

Example other_is_canonical_with_edge : canonical square [(a, c)] other.
Proof.
  by_checker true (whole Hull [za; zb; zc; zd] [ZEdge za [] zc None] [za; zb; zc]
      [ZTriangle za zb zc (Marks false false true) 0 [] []; ZTriangle za zc zd (Marks true false false) 0 [] []])
    accepted_is_canonical.
Qed.

Example upright_is_right : canonical kite [] upright.
Proof.
  by_checker true (whole Hull [ZPoint 0 0; ZPoint 4 (-1); ZPoint 8 0; ZPoint 4 1] [] [ZPoint 0 0;
    ZPoint 4 (-1); ZPoint 8 0]
      [ZTriangle (ZPoint 4 (-1)) (ZPoint 8 0) (ZPoint 4 1) no 0 [] [];
        ZTriangle (ZPoint 0 0) (ZPoint 4 (-1)) (ZPoint 4 1) no 0 [] []])
    accepted_is_canonical.
Qed.

Example level_is_right_with_edge : canonical kite [(w, e)] level.
Proof.
  by_checker true (whole Hull [ZPoint 0 0; ZPoint 4 (-1); ZPoint 8 0;
    ZPoint 4 1] [ZEdge (ZPoint 0 0) [] (ZPoint 8 0) None]
      [ZPoint 0 0; ZPoint 4 (-1); ZPoint 8 0]
      [ZTriangle (ZPoint 0 0) (ZPoint 4 (-1)) (ZPoint 8 0) (Marks false false true) 0 [] [];
       ZTriangle (ZPoint 0 0) (ZPoint 8 0) (ZPoint 4 1) (Marks true false false) 0 [] []])
    accepted_is_canonical.
Qed.

(* The ring a, b, d holds one of the two triangles of the fan. *)
Definition ring := [(a, b); (b, d); (d, a)].
Definition outline := [(a, b); (b, c); (c, d); (d, a)].
Definition zring n := [ZEdge za [] zb n; ZEdge zb [] zd n; ZEdge zd [] za n].
Definition zoutline n := [ZEdge za [] zb n; ZEdge zb [] zc n; ZEdge zc [] zd n; ZEdge zd [] za n].
Definition all_sides := Marks true true true.

Ltac interior_by_checker rule edges v low w left right :=
  let H := fresh in
  assert (H : check true (whole rule [za; zb; zc; zd] edges [za; zb; zc]
    [ZTriangle za zb zd all_sides v low []; ZTriangle zd zb zc all_sides w left right]) = true) by (vm_compute; reflexivity);
  apply (accepted_inside_is_interior 1 Rlt_0_1) in H; cbn [domain] in H;
  unfold real_edges, real_triangles, real_inside, real_polygons, Domain.real_polygon, Domain.ring_edges,
    Domain.inside_triangles, place_triangle, place_edge in H;
  cbn -[place in_polygons interior] in H; unfold za, zb, zc, zd in H; rewrite ?placed in H; exact H.

Example inside_of_a_ring : interior (nonzero (ring ++ outline)) fan fan.
Proof. interior_by_checker NonZero (zring None ++ zoutline None) 2%Z (@nil Z) 1%Z (@nil Z) (@nil Z). Qed.

Example inside_of_two_rings : interior (even_odd (ring ++ outline)) fan [(d, b, c)].
Proof. interior_by_checker EvenOdd (zring None ++ zoutline None) 0%Z (@nil Z) 1%Z (@nil Z) (@nil Z). Qed.

(* The ring is a hole, or a polygon that lies over the other one, or a line that bounds nothing. *)
Example inside_of_a_polygon_with_a_hole : interior (in_polygons [([outline], [ring])]) fan [(d, b, c)].
Proof.
  interior_by_checker (Polygons [ZPolygon [0%Z] [1%Z]]) (zring (Some 1%Z) ++ zoutline (Some 0%Z))
    0%Z [0%Z; 1%Z] 1%Z [1%Z] [0%Z].
Qed.

Example inside_of_two_polygons : interior (in_polygons [([outline], []); ([ring], [])]) fan fan.
Proof.
  interior_by_checker (Polygons [ZPolygon [0%Z] []; ZPolygon [1%Z] []]) (zring (Some 1%Z) ++ zoutline (Some 0%Z))
    1%Z [0%Z; 1%Z] 1%Z [1%Z] [0%Z].
Qed.

Example inside_of_a_polygon_with_lines : interior (in_polygons [([ring], [])]) fan [(a, b, d)].
Proof.
  interior_by_checker (Polygons [ZPolygon [1%Z] []]) (zring (Some 1%Z) ++ zoutline None)
    1%Z [1%Z] 0%Z [1%Z] (@nil Z).
Qed.

Example round_the_ring : winding ring (Point (1 / 2) (1 / 2)) = 1%Z /\ winding ring (Point (3 / 2) (3 / 2)) = 0%Z.
Proof.
  unfold winding, below_right, ring. compute_points. cbn [fold_right].
  split; repeat (destruct (Rle_dec _ _) || destruct (Rlt_dec _ _)); cbn [X Y] in *; try lra; reflexivity.
Qed.

(* Wrong. *)
Ltac refute H := intros [H | [_ H]]; [| discriminate H].

Example other_breaks_the_rule : ~ first_corner_rule square [] other.
Proof.
  intros H.
  assert (C : on_circle d (a, b, c)).
  { exists m. compute_points. split; [lra|]. intros x [->|[->| ->]]; cbn; lra. }
  assert (D : ~ first_of c [c; a; b; d]).
  { intros F. specialize (F d ltac:(cbn; auto)). compute_points. destruct F as [F|F]; [injection F|]; lra. }
  assert (G : ~ first_of a [c; a; b; d]).
  { intros F. specialize (F d ltac:(cbn; auto)). compute_points. destruct F as [F|F]; [injection F|]; lra. }
  assert (N : b <> c /\ b <> a) by (split; intros K; injection K; lra).
  assert (Q : in_interior (Point (3 / 2) (1 / 2)) (a, b, c)) by (compute_points; lra).
  assert (O : orient c a d < 0) by (compute_points; lra).
  destruct (H (a, b, c) c a b d _ ltac:(cbn; auto) ltac:(cbn; auto) ltac:(cbn; auto) (proj1 N) (proj2 N)
    ltac:(cbn; auto 6) C O Q) as [(x & y & [] & _)|[F|F]]; auto.
Qed.

Example without_the_edge : ~ constrained_delaunay square [(a, c)] fan.
Proof.
  refute H. destruct (edges_are_sides _ _ _ H a c m) as (t & x & y & It & S & Q & (r & R & Ex) & (v & V & Ey)).
  - left; reflexivity.
  - compute_points. intros K. injection K. lra.
  - exists (1 / 2). split; [lra|]. unfold between. compute_points. f_equal; lra.
  - unfold between in Ex, Ey. destruct It as [<-|[<-|[]]]; cbn in S; unfold a, b, c, d in *; cbn in Ex, Ey;
      destruct S as [S|[S|S]]; injection S as -> ->; injection Ex; injection Ey; intros; lra.
Qed.

Example twice : ~ constrained_delaunay square [] [(a, b, d); (d, b, c); (a, b, d)].
Proof.
  refute H. apply (no_overlap _ _ _ H 0 2 (a, b, d) (a, b, d) (Point (1 / 2) (1 / 2)) ltac:(discriminate) eq_refl
    eq_refl).
  compute_points. lra.
Qed.

Example half_of_the_square : ~ constrained_delaunay square [] [(a, b, d)].
Proof.
  refute H. destruct (all_corners _ _ _ H c) as (t & [<-|[]] & C); [cbn; auto|].
  compute_points. destruct C as [C|[C|C]]; injection C; lra.
Qed.

Example a_dent : ~ constrained_delaunay [a; b; c; d; m] [] [(a, b, m); (b, c, m); (c, d, m)].
Proof.
  refute H.
  destruct (proj1 (covers_hull _ _ _ H (Point (1 / 4) 1))) as (t & It & Q).
  - intros u v x L. pose proof (L a ltac:(cbn; auto)). pose proof (L d ltac:(cbn; auto)).
    pose proof (L m ltac:(cbn; auto 6)).
    compute_points. lra.
  - destruct It as [<-|[<-|[<-|[]]]]; compute_points; lra.
Qed.

Example a_point_left_out : ~ constrained_delaunay [a; b; c; d; m] [] fan.
Proof.
  refute H. pose proof (no_point_within _ _ _ H m (a, b, d) ltac:(cbn; auto 6) ltac:(cbn; auto)) as K.
  compute_points. destruct K as [K|[K|K]]; [lra|injection K; lra..].
Qed.

Example clockwise : ~ constrained_delaunay square [] [(a, d, b); (d, b, c)].
Proof. refute H. pose proof (turns_left _ _ _ H a d b ltac:(cbn; auto)). compute_points. lra. Qed.

Example a_strange_corner : ~ constrained_delaunay [a; b; d] [] fan.
Proof.
  refute H. pose proof (corners_given _ _ _ H (d, b, c) c ltac:(cbn; auto) ltac:(cbn; auto)) as K.
  compute_points. destruct K as [K|[K|[K|[]]]]; injection K; lra.
Qed.

Example level_is_not_delaunay : ~ constrained_delaunay kite [] level.
Proof.
  refute H. destruct (delaunay _ _ _ H (w, s, e) n (Point 4 (-1 / 2))) as (x & y & [] & _).
  - cbn; auto.
  - cbn; auto 6.
  - exists (Point 4 (15 / 2)). compute_points. split; [lra|]. intros x [->|[->| ->]]; cbn; lra.
  - compute_points. lra.
Qed.

Example an_edge_elsewhere_does_not_help : ~ constrained_delaunay kite [(w, s)] level.
Proof.
  refute H. destruct (delaunay _ _ _ H (w, s, e) n (Point 4 (-1 / 2))) as (x & y & [K|[]] & C).
  - cbn; auto.
  - cbn; auto 6.
  - exists (Point 4 (15 / 2)). compute_points. split; [lra|]. intros x [->|[->| ->]]; cbn; lra.
  - compute_points. lra.
  - injection K as <- <-. compute_points. lra.
Qed.

(* A hole is not covered, and of polygons none takes away what another one covers. *)
Example a_hole_is_not_inside : ~ interior (in_polygons [([outline], [ring])]) fan fan.
Proof.
  intros [_ H]. destruct (proj1 (H (a, b, d) (Point (1 / 2) (1 / 2)) ltac:(cbn; auto) ltac:(compute_points; lra)))
    as (p & [<-|[]] & _ & N); [cbn; auto|].
  apply (N ring); [cbn; auto|]. exists 0%Z. apply round_the_ring.
Qed.

Example polygons_are_not_even_odd : ~ interior (in_polygons [([outline], []); ([ring], [])]) fan [(d, b, c)].
Proof.
  intros [_ H].
  assert (I : In (a, b, d) [(d, b, c)]).
  { apply (H (a, b, d) (Point (1 / 2) (1 / 2))); [cbn; auto|compute_points; lra|].
    exists ([ring], []). split; [cbn; auto|]. split; [|intros r []].
    exists ring. split; [cbn; auto|]. exists 0%Z. apply round_the_ring. }
  destruct I as [I|[]]. compute_points. injection I. lra.
Qed.
