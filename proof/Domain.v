(* The triangles marked as inside are the interior.

   Each triangle has a value, and the value rises from the triangle below a side to the one above it by the edges along
   the side. So the sum over all triangles of value times count is the sum over all edges of their counts, which is the
   winding number. Of all counts only that of the triangle that holds the point is 1. No path is followed. *)
Require Import Reals ZArith List Lra Lia Bool Permutation.
Require Import Spec Geometry Count Sort Check Place Border Laid Pieces Tiling Cover.
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

Lemma fall_risen n q a b : risen u n q (fall n a b) = (- signed (place u a) (place u b) q)%Z.
Proof.
  unfold fall, risen, signed. destruct (before a b) eqn:B; cbn [rise rise_ring rise_side left_end right_end];
    rewrite Z.eqb_refl.
  - apply (before_lex u u_positive) in B. rewrite (lex_right _ _ q (or_introl B)). lia.
  - apply (not_before u u_positive) in B. rewrite (lex_right (place u b) (place u a) q); [lia|].
    destruct B as [->|B]; auto.
Qed.

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

Lemma falls_of_total n q b : forall through a acc0 l acc, pieces_of a through b acc0 = Some l ->
  total (risen u n q) (falls_of n a through b acc) = (total (risen u n q) acc - signed (place u a) (place u b) q)%Z.
Proof.
  induction through as [|v r IH]; cbn [pieces_of falls_of]; intros a acc0 l acc H.
  - rewrite total_cons, fall_risen. lia.
  - destruct (inside a v b) eqn:V; [|discriminate]. rewrite (IH _ _ _ _ H), total_cons, fall_risen.
    rewrite (inside_signed a v b q V). lia.
Qed.

Lemma falls_of_other n m q b : n <> m -> forall through a acc,
  total (risen u n q) (falls_of m a through b acc) = total (risen u n q) acc.
Proof.
  intros N. assert (F : forall a v, risen u n q (fall m a v) = 0%Z).
  { intros a v. unfold risen, fall. destruct (before a v); cbn [rise_ring]; destruct (Z.eqb_spec n m); congruence. }
  induction through as [|v r IH]; cbn [falls_of]; intros a acc; [|rewrite IH]; rewrite total_cons, F; reflexivity.
Qed.

(* The edges of ring n. *)
Definition in_ring (ring_of : zedge -> option Z) (n : Z) (e : zedge) : bool :=
  match ring_of e with
  | Some m => Z.eqb n m
  | None => false
  end.
Definition ring_edges (ring_of : zedge -> option Z) (n : Z) (es : list zedge) : list edge :=
  map (place_edge u) (filter (in_ring ring_of n) es).

Lemma falls_total ring_of n q : forall es acc0 l acc, pieces es acc0 = Some l ->
  total (risen u n q) (falls ring_of es acc) = (total (risen u n q) acc - winding (ring_edges ring_of n es) q)%Z.
Proof.
  unfold ring_edges. induction es as [|e r IH]; intros acc0 l acc H.
  - cbn [falls filter map winding fold_right]. lia.
  - cbn [pieces falls filter] in *. unfold in_ring at 1. destruct (same (edge_from e) (edge_to e)) eqn:S.
    + apply same_eq in S. destruct (ring_of e) as [m|]; [destruct (Z.eqb n m)|]; rewrite (IH _ _ _ H);
        try reflexivity.
      cbn [map winding fold_right place_edge]. fold (winding (map (place_edge u) (filter (in_ring ring_of n) r)) q).
      rewrite S. lia.
    + destruct (pieces_of _ _ _ acc0) as [acc1|] eqn:P; [|discriminate].
      destruct (ring_of e) as [m|]; [|apply (IH _ _ _ H)]. rewrite (IH _ _ _ H).
      destruct (Z.eqb_spec n m) as [<-|N]; [|rewrite (falls_of_other n m q _ N); reflexivity].
      cbn [map winding fold_right place_edge]. fold (winding (map (place_edge u) (filter (in_ring ring_of n) r)) q).
      rewrite (falls_of_total n q _ _ _ _ _ acc P). unfold signed. lia.
Qed.

Lemma last_rises_total n q : forall l acc, total (risen u n q) (last_rises l acc) = (total (risen u n q) acc
  - total (fun i => times_of n (level i) * above (left_of (item_side i)) (right_of (item_side i)) q) l)%Z.
Proof.
  induction l as [|i l IH]; intros acc; cbn [last_rises]; [cbn [total fold_right]; lia|].
  rewrite IH, add_rise_total, total_cons. cbn [times_of]. lia.
Qed.

Lemma compare_rises_eq x y : compare_rises x y = Eq -> rise_side x = rise_side y /\ rise_ring x = rise_ring y.
Proof.
  unfold compare_rises. destruct (compare_sides _ _) eqn:S; try discriminate. intros R.
  apply compare_sides_eq in S. apply Z.compare_eq in R. auto.
Qed.

(* Sums over the sides that balance: what fits each side and ring fits all. *)
Lemma balanced_total (fits : Z -> bool) (good : Z -> Prop) n q :
  (forall x k, fits x = true -> good (x * k)%Z) -> (forall x y, good x -> good y -> good (x + y)%Z) ->
  forall l x sum, balanced fits x sum l = true ->
    good (risen u n q (Rise (rise_side x) (rise_ring x) sum) + total (risen u n q) l)%Z.
Proof.
  intros Times Plus. assert (Fits : forall x sum, fits sum = true ->
    good (risen u n q (Rise (rise_side x) (rise_ring x) sum))).
  { intros x sum F. unfold risen. cbn [rise rise_ring rise_side]. destruct (Z.eqb _ _); [apply Times; assumption|].
    replace 0%Z with (sum * 0)%Z by lia. apply Times; assumption. }
  induction l as [|y l IH]; cbn [balanced]; intros x sum H.
  - cbn [total fold_right]. rewrite Z.add_0_r. apply Fits; assumption.
  - rewrite total_cons.
    assert (G : fits sum && balanced fits y (rise y) l = true ->
      good (risen u n q (Rise (rise_side x) (rise_ring x) sum) + (risen u n q y + total (risen u n q) l))%Z).
    { intros K. apply andb_prop in K. destruct K as [K1 K2]. apply Plus; [apply Fits; assumption|].
      apply IH in K2. destruct y. exact K2. }
    destruct (compare_rises x y) eqn:C; [|apply G; assumption|apply G; assumption].
    apply compare_rises_eq in C. destruct C as [S R]. apply IH in H.
    replace (risen u n q (Rise (rise_side x) (rise_ring x) sum) + (risen u n q y + total (risen u n q) l))%Z
      with (risen u n q (Rise (rise_side x) (rise_ring x) (sum + rise y)) + total (risen u n q) l)%Z; [assumption|].
    unfold risen. cbn [rise rise_ring rise_side]. rewrite S, R. destruct (Z.eqb n (rise_ring y)); ring.
Qed.

Lemma all_balanced_total (fits : Z -> bool) (good : Z -> Prop) n q l : good 0%Z ->
  (forall x k, fits x = true -> good (x * k)%Z) -> (forall x y, good x -> good y -> good (x + y)%Z) ->
  all_balanced fits l = true -> good (total (risen u n q) l).
Proof.
  intros Zero Times Plus H. unfold all_balanced in H.
  rewrite <- (total_permutation _ _ _ (sort_permutes compare_rises l)).
  destruct (sort _ l) as [|x r]; [assumption|]. rewrite total_cons.
  apply (balanced_total fits good n q Times Plus) in H. destruct x. exact H.
Qed.

(* For each ring, and up to what the rule does not see, the value of a triangle is the winding number. *)
Lemma values_are_winding rule k t n q : check rule k = true -> In t (triangles k) -> in_interior q (tri t) ->
  let error ring_of := (times_of n (value t) - winding (ring_edges ring_of n (edges k)) q)%Z in
  match domain k with
  | Hull => True
  | EvenOdd => Z.Even (error one_ring)
  | NonZero => error one_ring = 0%Z
  | Polygons _ => Z.Even (error edge_ring)
  end.
Proof.
  intros H I Q error. assert (N : triangles k <> []) by (destruct (triangles k); [destruct I|discriminate]).
  pose proof (check_tiled u u_positive rule k H N) as T.
  destruct (check_inv rule k H N) as (s & ps & L & PS & _ & B & _ & _ & VR). cbn zeta in *.
  destruct (lay_laid u u_positive rule k s B L) as (done & LD & PD).
  pose proof (l_values _ _ _ _ _ _ LD n q) as C.
  set (fr := rev_append (passed s) (ahead s)) in *.
  assert (PF : Permutation (front s) fr).
  { unfold fr, front. rewrite rev_append_rev. apply Permutation_app_tail, Permutation_rev. }
  assert (V : total (fun t => (times_of n (value t) * count q (tri t))%Z) done = times_of n (value t)).
  { apply (total_only (fun t => count q (tri t)) (fun t => times_of n (value t))).
    - intros x Hx. apply count_triangle. apply (l_positive _ _ _ _ _ _ LD). assumption.
    - pose proof (t_once _ _ _ _ T q) as O.
      rewrite (total_permutation _ _ _ PD).
      assert (E : total (fun t => count q (tri t)) (triangles k) = total (count q) (map tri (triangles k))).
      { clear. induction (triangles k) as [|x r IH]; [reflexivity|]. cbn [map]. rewrite !total_cons, IH. reflexivity. }
      lia.
    - apply Permutation_in with (triangles k); [symmetry|]; assumption.
    - apply count_triangle; [|assumption]. apply interior_positive with q; assumption. }
  rewrite V, (total_permutation _ _ _ PF) in C.
  pose proof (last_rises_total n q fr (rises s)) as LR.
  assert (E : forall ring_of, total (risen u n q) (falls ring_of (edges k) (last_rises fr (rises s))) = error ring_of).
  { intros ring_of. rewrite (falls_total ring_of n q (edges k) [] ps _ PS). unfold error. lia. }
  assert (Even : forall ring_of, all_balanced Z.even (falls ring_of (edges k) (last_rises fr (rises s))) = true ->
    Z.Even (error ring_of)).
  { intros ring_of. rewrite <- E. apply all_balanced_total.
    - exists 0%Z; reflexivity.
    - intros x y X. apply Z.even_spec in X. destruct X as [z ->]. exists (z * y)%Z. ring.
    - intros x y [z ->] [w ->]. exists (z + w)%Z. ring. }
  unfold values_right in VR. destruct (domain k).
  - trivial.
  - apply Even in VR. exact VR.
  - rewrite <- E. revert VR. apply (all_balanced_total (Z.eqb 0) (fun x => x = 0%Z)); [reflexivity| |intros; lia].
    intros x y X. apply Z.eqb_eq in X. subst. reflexivity.
  - apply Even in VR. exact VR.
Qed.

Lemma one_ring_edges es : ring_edges one_ring 0 es = map (place_edge u) es.
Proof. unfold ring_edges. f_equal. induction es as [|e r IH]; cbn; [|rewrite IH]; reflexivity. Qed.

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
  intros H I Q. pose proof (fun n => values_are_winding rule k t n q H I Q) as V. cbn zeta in V.
  unfold is_inside, inside_by, is_odd. destruct (domain k) as [| | |ps].
  - tauto.
  - unfold even_odd. rewrite <- one_ring_edges. apply even_difference, V.
  - unfold nonzero. rewrite <- one_ring_edges. specialize (V 0%Z).
    destruct (Z.eqb_spec (times_of 0 (value t)) 0); cbn [negb]; split; intros; try easy; lia.
  - assert (Rings : forall l, existsb (fun n => Z.odd (times_of n (value t))) l = true <->
      exists r, In r (map (fun n => ring_edges edge_ring n (edges k)) l) /\ even_odd r q).
    { intros l. rewrite existsb_exists. split.
      - intros (n & J & O). eexists. split; [apply in_map; exact J|]. apply (even_difference _ _ (V n)). assumption.
      - intros (r & J & O). apply in_map_iff in J. destruct J as (n & <- & J). exists n. split; [assumption|].
        apply (even_difference _ _ (V n)). assumption. }
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
