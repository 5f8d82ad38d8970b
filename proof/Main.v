(* What the checker accepts is right. *)
Require Import Reals ZArith List Lra Lia Bool.
Require Import Spec Geometry Rings Check Place Course Tiling Walk Unique Domain.
Import ListNotations.
Open Scope R_scope.

Definition real_points (u : R) (k : certificate) : list point := map (place u) (points k).
Definition real_edges (u : R) (k : certificate) : list edge := map (place_edge u) (edges k).
Definition real_triangles (u : R) (k : certificate) : list triangle := map (place_triangle u) (triangles k).

Definition real_polygons (u : R) (k : certificate) (ps : list zpolygon) : list polygon :=
  map (real_polygon u (edges k)) ps.

Lemma parallel a b x y z : a <> b -> orient a b x = 0 -> orient a b y = 0 -> orient a b z = 0 -> orient x y z = 0.
Proof.
  intros N A B C.
  assert (E1 : (X b - X a) * orient x y z = (X y - X x) * (orient a b z - orient a b x)
     - (X z - X x) * (orient a b y - orient a b x)) by (flat; ring).
  assert (E2 : (Y b - Y a) * orient x y z = (Y y - Y x) * (orient a b z - orient a b x)
     - (Y z - Y x) * (orient a b y - orient a b x)) by (flat; ring).
  rewrite A, B, C in E1, E2.
  destruct (Req_dec (X b - X a) 0) as [Z|Z].
  - destruct (Req_dec (Y b - Y a) 0) as [W|W]; [exfalso; apply N; apply point_eq; lra|].
    apply Rmult_eq_reg_l with (Y b - Y a); lra.
  - apply Rmult_eq_reg_l with (X b - X a); lra.
Qed.

Definition real_inside (u : R) (k : certificate) : list triangle := inside_triangles u k.

Section Main.
Variable u : R.
Hypothesis u_positive : 0 < u.

(* How the points that were seen lie. *)
Definition line_right (l : line) (ps : list zpoint) : Prop :=
  match l with
  | NoPoint => ps = []
  | OnePlace a => forall p, In p ps -> p = a
  | OnLine a b => a <> b /\ forall p, In p ps -> orient (place u a) (place u b) (place u p) = 0
  | OffLine => True
  end.

Lemma see_right p l ps : line_right l ps -> line_right (see p l) (ps ++ [p]).
Proof.
  destruct l as [|a|a b|]; cbn [see line_right]; [intros ->; cbn; intuition| | |trivial].
  - intros H. destruct (same a p) eqn:S; cbn [line_right].
    + apply same_eq in S. subst p. intros x I. apply in_app_or in I. destruct I as [I|[<-|[]]]; auto.
    + split; [intros ->; rewrite same_refl in S; discriminate|]. intros x I. apply in_app_or in I.
      destruct (orient_same (place u a) (place u p)). destruct I as [I|[<-|[]]]; [rewrite (H x I)|]; assumption.
  - intros [N H]. destruct (Z.eqb_spec (zorient a b p) 0) as [Z|]; cbn [line_right]; [|trivial]. split; [assumption|].
    intros x I. apply in_app_or in I. destruct I as [I|[<-|[]]]; [auto|]. apply (place_orient_zero u u_positive). assumption.
Qed.

Lemma line_of_right ps : line_right (line_of ps) ps.
Proof.
  induction ps as [|p ps IH] using rev_ind; [reflexivity|]. unfold line_of. rewrite fold_left_app. apply see_right, IH.
Qed.

Lemma one_line_spec k : line_of (points k) <> OffLine -> on_one_line (real_points u k).
Proof.
  unfold real_points. pose proof (line_of_right (points k)) as L. intros N x y z Hx Hy Hz.
  apply in_map_iff in Hx, Hy, Hz. destruct Hx as (x' & <- & Hx), Hy as (y' & <- & Hy), Hz as (z' & <- & Hz).
  destruct (line_of (points k)) as [|a|a b|]; cbn [line_right] in L.
  - rewrite L in Hx. destruct Hx.
  - rewrite (L x'), (L y'), (L z') by assumption. destruct (orient_same (place u a) (place u a)); assumption.
  - destruct L as [D L]. apply parallel with (place u a) (place u b); auto.
    intros K. apply D. apply (place_injective u u_positive) in K. auto.
  - congruence.
Qed.

(* The level of any right triangulation. *)
Theorem accepted_is_constrained_delaunay rule k : check rule k = true ->
  constrained_delaunay (real_points u k) (real_edges u k) (real_triangles u k).
Proof.
  intros H. destruct (triangles k) eqn:T.
  - right. split; [|unfold real_triangles; rewrite T; reflexivity].
    apply one_line_spec. apply check_empty with rule; assumption.
  - left. apply (tiled_triangulation rule). apply check_tiled; [assumption..|]. rewrite T. discriminate.
Qed.

(* The level of the one triangulation with the rule of the first corner. *)
Theorem accepted_is_canonical k : check true k = true ->
  canonical (real_points u k) (real_edges u k) (real_triangles u k).
Proof.
  intros H. split; [apply accepted_is_constrained_delaunay with true; assumption|].
  destruct (triangles k) eqn:T.
  - unfold real_triangles. rewrite T. intros t a b c p q [].
  - apply (tiled_first_corner true); [|reflexivity]. apply check_tiled; [assumption..|]. rewrite T. discriminate.
Qed.
(* The triangles that are inside by their values are the interior by the rule of the domain. *)
Theorem accepted_inside_is_interior rule k : check rule k = true ->
  match domain k with
  | Hull => True
  | EvenOdd => interior (even_odd (real_edges u k)) (real_triangles u k) (real_inside u k)
  | NonZero => interior (nonzero (real_edges u k)) (real_triangles u k) (real_inside u k)
  | Polygons ps => interior (in_polygons (real_polygons u k ps)) (real_triangles u k) (real_inside u k)
  end.
Proof.
  intros H. pose proof (inside_is_interior u u_positive rule k H) as I. unfold is_inside in I.
  destruct (domain k); [trivial|exact I..].
Qed.
End Main.

(* Two accepted certificates of the same points and edges have the same triangles. Their integers may differ, and their
   units, if the points are the same. *)
Theorem accepted_are_the_same u v k l : 0 < u -> 0 < v -> check true k = true -> check true l = true ->
  same_points (real_points u k) (real_points v l) -> same_edges (real_edges u k) (real_edges v l) ->
  same_triangles (real_triangles u k) (real_triangles v l).
Proof.
  intros U V K L SP SE.
  apply (canonical_unique (real_points u k) (real_edges u k) (real_points v l) (real_edges v l)); try assumption;
    apply accepted_is_canonical; assumption.
Qed.
