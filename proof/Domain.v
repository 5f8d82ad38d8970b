(* The triangles marked as inside are the interior.

   Each triangle has a value, and the value rises from the triangle below a side to the one above it by the edges along
   the side (Values.v). So the sum over all triangles of value times count is the sum over all edges of their counts,
   which is the winding number. Of all counts only that of the triangle that holds the point is 1. No path is followed. *)
Require Import Reals ZArith List Lra Lia Bool Permutation.
Require Import Spec Geometry Count Sort Rings Check Place Border Laid Pieces Values Course Tiling Cover.
Import ListNotations.
Open Scope R_scope.

(* A side split at a point. *)
Lemma above_split a v b q : lex a v -> lex v b -> orient a b v = 0 -> above a b q = (above a v q + above v b q)%Z.
Proof.
  intros A B O. destruct (on_segment_lex a v b O A B) as [s [S E]].
  assert (XE : X v - X a = s * (X b - X a)) by (rewrite E; cbn; ring).
  assert (O1 : orient a v q = s * orient a b q) by (rewrite E; flat; ring).
  assert (O2 : orient v b q = (1 - s) * orient a b q) by (rewrite E; flat; ring).
  unfold lex in A, B. unfold below_right. rewrite O1, O2.
  destruct (Rle_dec (X a) (X q)), (Rlt_dec (X q) (X b)), (Rle_dec (X v) (X q)), (Rlt_dec (X q) (X v)); try lra;
    try reflexivity.
  - assert (S' : 0 < 1 - s) by nra.
    destruct (Rlt_dec 0 (orient a b q)), (Rlt_dec 0 ((1 - s) * orient a b q)); try reflexivity; exfalso; nra.
  - assert (S' : 0 < s) by nra.
    destruct (Rlt_dec 0 (orient a b q)), (Rlt_dec 0 (s * orient a b q)); try reflexivity; exfalso; nra.
Qed.

Lemma total_only {A} (f g : A -> Z) l z : (forall x, In x l -> (0 <= f x)%Z) -> (total f l <= 1)%Z -> In z l ->
  f z = 1%Z ->
  total (fun x => (g x * f x)%Z) l = g z.
Proof.
  intros P L I F. apply in_split in I. destruct I as (l1 & l2 & ->). rewrite total_app, total_cons in *.
  assert (P1 : forall x, In x l1 -> (0 <= f x)%Z) by (intros; apply P; apply in_or_app; auto).
  assert (P2 : forall x, In x l2 -> (0 <= f x)%Z) by (intros; apply P; apply in_or_app; cbn; auto).
  pose proof (total_nonneg f l1 P1). pose proof (total_nonneg f l2 P2).
  assert (Z : forall l, (forall x, In x l -> (0 <= f x)%Z) -> total f l = 0%Z ->
    total (fun x => (g x * f x)%Z) l = 0%Z).
  { clear. induction l as [|x l IH]; intros P T; [reflexivity|]. rewrite total_cons in *.
    pose proof (P x (or_introl eq_refl)).
    pose proof (total_nonneg f l (fun y Hy => P y (or_intror Hy))).
    assert (f x = 0%Z) by lia. rewrite IH; [rewrite H1; lia|intros; apply P; cbn; auto|lia]. }
  rewrite (Z l1 P1), (Z l2 P2) by lia. rewrite F. lia.
Qed.

Section Domain.
Variable u : R.
Hypothesis u_positive : 0 < u.

Notation tri := (place_triangle u).
Notation left_of s := (place u (left_end s)).
Notation right_of s := (place u (right_end s)).

Lemma lex_right a b q : lex a b \/ a = b -> above b a q = 0%Z.
Proof. intros H. apply above_right. unfold lex in H. destruct H as [H| ->]; lra. Qed.

Lemma inside_signed a v b q : inside a v b = true ->
  signed (place u a) (place u b) q = (signed (place u a) (place u v) q + signed (place u v) (place u b) q)%Z.
Proof.
  unfold inside. intros H. apply andb_prop in H. destruct H as [O H]. apply Z.eqb_eq in O.
  apply (place_orient_zero u u_positive) in O. unfold signed.
  apply orb_prop in H. destruct H as [H|H]; apply andb_prop in H; destruct H as [A B];
    apply (before_lex u u_positive) in A, B.
  - rewrite (above_split _ _ _ q A B O), (lex_right _ _ q (or_introl A)), (lex_right _ _ q (or_introl B)).
    rewrite (lex_right _ _ q (or_introl (lex_transitive _ _ _ A B))). lia.
  - assert (O' : orient (place u b) (place u a) (place u v) = 0) by (rewrite orient_swap; lra).
    rewrite (above_split _ _ _ q A B O'), (lex_right _ _ q (or_introl A)), (lex_right _ _ q (or_introl B)).
    rewrite (lex_right _ _ q (or_introl (lex_transitive _ _ _ A B))). lia.
Qed.

(* The edges of ring n. *)
Definition ring_edges (ring_of : zedge -> option Z) (n : Z) (es : list zedge) : list edge :=
  map (place_edge u) (filter (in_ring ring_of n) es).

(* The count as a function of sides. *)
Definition passes (q : point) (a b : zpoint) : Z := signed (place u a) (place u b) q.

Lemma passes_odd q : Values.is_odd (passes q).
Proof. intros a b. apply signed_odd. Qed.

Lemma passes_adds q : adds_up (passes q).
Proof. intros a v b. apply inside_signed. Qed.

Lemma round_winding ring_of n es q : round_ring (passes q) ring_of n es = winding (ring_edges ring_of n es) q.
Proof.
  unfold round_ring, ring_edges, winding. induction (filter (in_ring ring_of n) es) as [|e r IH]; [reflexivity|].
  cbn [map fold_right place_edge]. rewrite total_cons, IH. reflexivity.
Qed.

Definition laid_once (k : certificate) : Prop :=
  (forall t, In t (map tri (triangles k)) -> positive t) /\ forall q, (total (count q) (map tri (triangles k)) <= 1)%Z.

(* A sum of values times counts, of which one count alone is not 0. *)
Lemma only_one {A} (tri_of : A -> ztriangle) (value_of : A -> Z) (l : list A) k z q :
  laid_once k -> Permutation (map tri_of l) (triangles k) -> In z l -> in_interior q (tri (tri_of z)) ->
  total (fun x => (value_of x * turn (passes q) (tri_of x))%Z) l = value_of z.
Proof.
  intros [Pos Once] P I Q.
  assert (M : forall x, In x l -> In (tri (tri_of x)) (map tri (triangles k))).
  { intros x X. apply in_map. apply (Permutation_in _ P). apply in_map. assumption. }
  apply (total_only (fun x => count q (tri (tri_of x)))).
  - intros x X. apply count_triangle. apply Pos, M, X.
  - assert (E : total (fun x => count q (tri (tri_of x))) l = total (count q) (map tri (triangles k))).
    { rewrite <- (total_permutation _ _ _ (Permutation_map tri P)), !total_map. reflexivity. }
    rewrite E. apply Once.
  - assumption.
  - apply count_triangle; [apply Pos, M, I|assumption].
Qed.

Lemma one_ring_edges es : ring_edges one_ring 0 es = map (place_edge u) es.
Proof. unfold ring_edges. f_equal. induction es as [|e r IH]; cbn; [|rewrite IH]; reflexivity. Qed.

Lemma checked_tiled rule k : check rule k = true -> triangles k <> [] -> laid_once k.
Proof.
  intros H N. pose proof (check_tiled u u_positive rule k H N) as T. split; [apply (t_positive _ _ _ _ T)|apply (t_once _ _ _ _ T)].
Qed.

Lemma front_last s : Permutation (front s) (rev_append (passed s) (ahead s)).
Proof. unfold front. rewrite rev_append_rev. apply Permutation_app_tail, Permutation_rev. Qed.

(* By even-odd and nonzero, up to what the rule does not see, the value of a triangle is the winding number. *)
Lemma value_is_winding rule k t q : check rule k = true -> In t (triangles k) -> in_interior q (tri t) ->
  let error := (value t - winding (map (place_edge u) (edges k)) q)%Z in
  match domain k with
  | EvenOdd => Z.Even error
  | NonZero => error = 0%Z
  | _ => True
  end.
Proof.
  intros H I Q error. assert (N : triangles k <> []) by (destruct (triangles k); [destruct I|discriminate]).
  pose proof (checked_tiled rule k H N) as T.
  destruct (check_inv rule k H N) as (low & f & r & th & h & s & ps & ends & [G _ _ _ _ _ _ _ PS _ _ VR _]).
  set (fr := rev_append (passed s) (ahead s)) in *. set (F := passes q).
  assert (E : judge_of (domain k) = None ->
    total (weigh (along F) 0) (rev_append (falls one_ring (edges k) []) (last_rises None fr (rises s))) = error).
  { intros J. rewrite J in G. apply (grown_value F (passes_odd q)) in G.
    rewrite total_rev_append, (falls_total F (passes_odd q) (passes_adds q) _ _ _ _ _ _ PS), last_rises_value.
    change (total (weigh (along F) 0) []) with 0%Z. unfold F. rewrite round_winding, one_ring_edges. fold F.
    rewrite <- (total_permutation _ _ _ (front_last s)).
    pose proof (only_one (fun t => t) value (triangles k) k t q T) as O. fold F in O.
    rewrite map_id in O. specialize (O (Permutation_refl _) I Q). unfold seen in G. unfold error. lia. }
  unfold values_right in VR. destruct (domain k); trivial; cbn [judge_of] in *; rewrite <- E by reflexivity.
  - apply all_even. exact VR.
  - revert VR. apply (all_balanced_total (along F) (Z.eqb 0) (fun x => x = 0%Z)); [reflexivity| |intros; lia].
    intros x y X. apply Z.eqb_eq in X. subst. reflexivity.
Qed.

(* By polygons, the rings around a triangle are those that go round each of its points, and its value says of them. *)
Lemma rings_are_winding rule k ps t q : check rule k = true -> domain k = Polygons ps -> In t (triangles k) ->
  in_interior q (tri t) ->
  exists w, good (table_of 1 ps (PM.empty _)) w /\ is_covered w = negb (Z.eqb (value t) 0) /\
    forall n, Z.Even (parity n w - winding (ring_edges edge_ring n (edges k)) q).
Proof.
  intros H D I Q. assert (N : triangles k <> []) by (destruct (triangles k); [destruct I|discriminate]).
  pose proof (checked_tiled rule k H N) as T.
  destruct (check_inv rule k H N) as (low & f & r & th & h & s & es & ends & [G _ _ _ _ _ _ _ PS _ _ VR Once]).
  rewrite D in G, VR, Once. cbn [judge_of values_right falls_in ends_in] in G, VR, Once.
  set (m := table_of 1 ps (PM.empty _)) in *. apply andb_prop in VR. destruct VR as [VR C].
  specialize (Once ltac:(discriminate)). destruct (grown_ringed _ _ _ _ _ _ G) as (done & M & R & P).
  assert (J : In t (map fst done)) by (apply (Permutation_in _ (Permutation_sym P)); assumption).
  apply in_map_iff in J. destruct J as ([t' w] & E & J). cbn [fst] in E. subst t'.
  destruct (r_done _ _ _ _ _ R _ J) as [Gw V]. cbn [fst snd] in Gw, V. exists w. split; [assumption|]. split; [assumption|].
  intros n. rewrite <- round_winding.
  pose proof (only_one fst (fun x => parity n (snd x)) done k (t, w) q T P J Q) as O. cbv beta in O. cbn [snd] in O.
  rewrite <- O.
  apply (rings_right m done M _ s _ (edges k) es R (front_last s) Once PS VR C);
    [apply passes_odd|apply passes_adds].
Qed.

Definition real_polygon (es : list zedge) (p : zpolygon) : polygon :=
  let ring n := ring_edges edge_ring n es in (map ring (outlines p), map ring (holes p)).

(* The rule of a domain, on real points. *)
Definition is_inside (k : certificate) : point -> Prop :=
  match domain k with
  | Hull => fun _ => True
  | EvenOdd => even_odd (map (place_edge u) (edges k))
  | NonZero => nonzero (map (place_edge u) (edges k))
  | Polygons ps => in_polygons (map (real_polygon (edges k)) ps)
  end.

Lemma even_difference x y : Z.Even (x - y) -> (Z.odd x = true <-> Z.Odd y).
Proof.
  intros [z D]. rewrite Z.odd_spec. split; intros [w W]; [exists (w - z)%Z|exists (w + z)%Z]; lia.
Qed.

Lemma inside_by_rule rule k t q : check rule k = true -> In t (triangles k) -> in_interior q (tri t) ->
  inside_by (domain k) t = true <-> is_inside k q.
Proof.
  intros H I Q. pose proof (value_is_winding rule k t q H I Q) as V. cbn zeta in V.
  pose proof (fun ps D => rings_are_winding rule k ps t q H D I Q) as W.
  unfold is_inside, inside_by. destruct (domain k) as [| | |ps].
  - tauto.
  - apply even_difference, V.
  - unfold nonzero. destruct (Z.eqb_spec (value t) 0); cbn [negb]; split; intros; try easy; lia.
  - destruct (W ps eq_refl) as (w & G & <- & E). rewrite (covered_spec ps w G).
    assert (Rings : forall l, existsb (fun r => has (key r) (Rings.odd w)) l = true <->
      exists r, In r (map (fun n => ring_edges edge_ring n (edges k)) l) /\ even_odd r q).
    { assert (Has : forall n, has (key n) (Rings.odd w) = Z.odd (parity n w)).
      { intros n. unfold parity. destruct (has (key n) (Rings.odd w)); reflexivity. }
      intros l. rewrite existsb_exists. split.
      - intros (n & J & O). eexists. split; [apply in_map; exact J|]. apply (even_difference _ _ (E n)).
        rewrite <- Has. assumption.
      - intros (r & J & O). apply in_map_iff in J. destruct J as (n & <- & J). exists n. split; [assumption|].
        rewrite Has. apply (even_difference _ _ (E n)). assumption. }
    unfold in_polygons. rewrite existsb_exists. split.
    + intros (p & J & C). apply andb_prop in C. destruct C as [A B].
      eexists. split; [apply in_map; exact J|]. split; [apply Rings; assumption|].
      intros r R O. apply negb_true_iff in B. rewrite (proj2 (Rings (holes p))) in B; [discriminate|].
      exists r. auto.
    + intros (p & J & C). apply in_map_iff in J. destruct J as (z & <- & J). destruct C as [A B].
      exists z. split; [assumption|]. apply andb_true_intro. split; [apply Rings; assumption|].
      apply negb_true_iff, not_true_is_false. intros K. apply Rings in K. destruct K as (r & R & O).
      apply (B r R O).
Qed.

Definition inside_triangles (k : certificate) : list triangle := map tri (filter (inside_by (domain k)) (triangles k)).

Theorem inside_is_interior rule k : check rule k = true ->
  interior (is_inside k) (map tri (triangles k)) (inside_triangles k).
Proof.
  intros H. pose proof (fun t q => inside_by_rule rule k t q H) as G. split.
  - intros t I. unfold inside_triangles in I. apply in_map_iff in I. destruct I as (z & <- & Z).
    apply filter_In in Z. apply in_map. tauto.
  - intros t q I Q. apply in_map_iff in I. destruct I as (z & <- & I). unfold inside_triangles. split.
    + intros J. apply in_map_iff in J. destruct J as (y & E & J). apply filter_In in J. destruct J as [J K].
      apply (G y q J); [rewrite E|]; assumption.
    + intros K. apply in_map_iff. exists z. split; [reflexivity|]. apply filter_In. split; [assumption|].
      apply (G z q I Q). assumption.
Qed.
End Domain.
