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

Lemma fall_risen q a b : risen u q (fall a b) = (- signed (place u a) (place u b) q)%Z.
Proof.
  unfold fall, risen, signed. destruct (before a b) eqn:B; cbn [rise rise_side left_end right_end].
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

Lemma falls_of_total q b : forall through a acc0 l acc, pieces_of a through b acc0 = Some l ->
  total (risen u q) (falls_of a through b acc) = (total (risen u q) acc - signed (place u a) (place u b) q)%Z.
Proof.
  induction through as [|v r IH]; cbn [pieces_of falls_of]; intros a acc0 l acc H.
  - rewrite total_cons, fall_risen. lia.
  - destruct (inside a v b) eqn:V; [|discriminate]. rewrite (IH _ _ _ _ H), total_cons, fall_risen.
    rewrite (inside_signed a v b q V). lia.
Qed.

Lemma falls_total q : forall es acc0 l acc, pieces es acc0 = Some l ->
  total (risen u q) (falls es acc) = (total (risen u q) acc - winding (map (place_edge u) es) q)%Z.
Proof.
  induction es as [|e r IH]; intros acc0 l acc H.
  - cbn [falls map winding fold_right]. lia.
  - cbn [pieces falls map winding fold_right place_edge] in *. fold (winding (map (place_edge u) r) q).
    destruct (same (edge_from e) (edge_to e)) eqn:S.
    + apply same_eq in S. rewrite (IH _ _ _ H), S. lia.
    + destruct (pieces_of _ _ _ acc0) as [acc1|] eqn:P; [|discriminate].
      rewrite (IH _ _ _ H), (falls_of_total q _ _ _ _ _ acc P). unfold signed. lia.
Qed.

Lemma last_rises_total q : forall l acc, total (risen u q) (last_rises l acc)
  = (total (risen u q) acc - total (fun i => level i * above (left_of (item_side i)) (right_of (item_side i)) q) l)%Z.
Proof.
  induction l as [|i l IH]; intros acc; cbn [last_rises]; [cbn [total fold_right]; lia|].
  rewrite IH, add_rise_total, total_cons. lia.
Qed.

(* Sums over the sides that balance: what fits each side fits all. *)
Lemma balanced_total (fits : Z -> bool) (good : Z -> Prop) q :
  (forall x k, fits x = true -> good (x * k)%Z) -> (forall x y, good x -> good y -> good (x + y)%Z) ->
  forall l s sum, balanced fits s sum l = true -> good (sum * above (left_of s) (right_of s) q + total (risen u q) l)%Z.
Proof.
  intros Times Plus. induction l as [|[t v] l IH]; cbn [balanced]; intros s sum H.
  - cbn. apply Plus; [apply Times; assumption|]. replace 0%Z with (sum * 0)%Z by lia. apply Times; assumption.
  - rewrite total_cons. unfold risen at 1. cbn [rise rise_side].
    assert (G : forall b, fits sum && balanced fits t v l = true -> b = true ->
      good (sum * above (left_of s) (right_of s) q + (v * above (left_of t) (right_of t) q + total (risen u q) l))%Z).
    { intros _ K _. apply andb_prop in K. destruct K as [K1 K2]. apply Plus; [apply Times; assumption|].
      apply IH; assumption. }
    destruct (compare_sides s t) eqn:C; [|apply (G true); auto|apply (G true); auto].
    apply compare_sides_eq in C. subst t. specialize (IH s (sum + v)%Z H).
    replace (sum * above (left_of s) (right_of s) q + (v * above (left_of s) (right_of s) q + total (risen u q) l))%Z
      with ((sum + v) * above (left_of s) (right_of s) q + total (risen u q) l)%Z by ring. assumption.
Qed.

Lemma all_balanced_total (fits : Z -> bool) (good : Z -> Prop) q l : good 0%Z ->
  (forall x k, fits x = true -> good (x * k)%Z) -> (forall x y, good x -> good y -> good (x + y)%Z) ->
  all_balanced fits l = true -> good (total (risen u q) l).
Proof.
  intros Zero Times Plus H. unfold all_balanced in H.
  pose proof (sort_permutes (fun x y => compare_sides (rise_side x) (rise_side y)) l) as P.
  rewrite <- (total_permutation _ _ _ P).
  destruct (sort _ l) as [|[s v] r]; [assumption|]. rewrite total_cons.
  apply (balanced_total fits good q Times Plus) in H. exact H.
Qed.

(* Up to what the rule does not see, the value of a triangle is the winding number. *)
Lemma values_are_winding rule k t q : check rule k = true -> In t (triangles k) -> in_interior q (tri t) ->
  match domain k with
  | Hull => True
  | EvenOdd => Z.Even (value t - winding (map (place_edge u) (edges k)) q)
  | NonZero => value t = winding (map (place_edge u) (edges k)) q
  end.
Proof.
  intros H I Q. assert (N : triangles k <> []) by (destruct (triangles k); [destruct I|discriminate]).
  pose proof (check_tiled u u_positive rule k H N) as T.
  destruct (check_inv rule k H N) as (s & ps & L & PS & _ & B & _ & _ & VR). cbn zeta in *.
  destruct (lay_laid u u_positive rule k s B L) as (done & LD & PD).
  pose proof (l_values _ _ _ _ _ _ LD q) as C.
  set (fr := rev_append (passed s) (ahead s)) in *.
  assert (PF : Permutation (front s) fr).
  { unfold fr, front. rewrite rev_append_rev. apply Permutation_app_tail, Permutation_rev. }
  assert (V : total (fun t => (value t * count q (tri t))%Z) done = value t).
  { apply (total_only (fun t => count q (tri t)) value).
    - intros x Hx. apply count_triangle. apply (l_positive _ _ _ _ _ _ LD). assumption.
    - pose proof (t_once _ _ _ _ T q) as O.
      rewrite (total_permutation _ _ _ PD).
      assert (E : total (fun t => count q (tri t)) (triangles k) = total (count q) (map tri (triangles k))).
      { clear. induction (triangles k) as [|x r IH]; [reflexivity|]. cbn [map]. rewrite !total_cons, IH. reflexivity. }
      lia.
    - apply Permutation_in with (triangles k); [symmetry|]; assumption.
    - apply count_triangle; [|assumption]. apply interior_positive with q; assumption. }
  rewrite V, (total_permutation _ _ _ PF) in C.
  pose proof (last_rises_total q fr (rises s)) as LR.
  pose proof (falls_total q (edges k) [] ps (last_rises fr (rises s)) PS) as FT.
  unfold values_right in VR. destruct (domain k); [trivial| |].
  - apply (all_balanced_total Z.even Z.Even q) in VR.
    + rewrite FT, LR, <- C in VR.
      replace (value t - winding (map (place_edge u) (edges k)) q)%Z
        with (value t + total (fun i => (level i * above (left_of (item_side i)) (right_of (item_side i)) q)%Z) fr
          - total (fun i => (level i * above (left_of (item_side i)) (right_of (item_side i)) q)%Z) fr
          - winding (map (place_edge u) (edges k)) q)%Z by ring. exact VR.
    + exists 0%Z; reflexivity.
    + intros x y E. apply Z.even_spec in E. destruct E as [z ->]. exists (z * y)%Z. ring.
    + intros x y [z ->] [w ->]. exists (z + w)%Z. ring.
  - apply (all_balanced_total (Z.eqb 0) (fun x => x = 0%Z) q) in VR; [lia|reflexivity| |intros; lia].
    intros x y E. apply Z.eqb_eq in E. subst. reflexivity.
Qed.

Definition inside_triangles (k : certificate) : list triangle := map tri (filter (inside_by (domain k)) (triangles k)).

Theorem inside_is_interior rule k (inside : point -> Prop) : check rule k = true ->
  (domain k = EvenOdd /\ inside = even_odd (map (place_edge u) (edges k))) \/
  (domain k = NonZero /\ inside = nonzero (map (place_edge u) (edges k))) ->
  interior inside (map tri (triangles k)) (inside_triangles k).
Proof.
  intros H D.
  assert (G : forall t q, In t (triangles k) -> in_interior q (tri t) -> inside_by (domain k) t = true <-> inside q).
  { intros t q I Q. pose proof (values_are_winding rule k t q H I Q) as V.
    destruct D as [[Dk ->]|[Dk ->]]; rewrite Dk in *; cbn [inside_by].
    - unfold even_odd. rewrite Z.odd_spec. destruct V as [z V].
      split; intros [w W]; [exists (w - z)%Z|exists (w + z)%Z]; lia.
    - unfold nonzero. rewrite V. destruct (Z.eqb_spec (winding (map (place_edge u) (edges k)) q) 0); cbn; split;
        auto; congruence. }
  split.
  - intros t I. unfold inside_triangles in I. apply in_map_iff in I. destruct I as (z & <- & Z).
    apply filter_In in Z. apply in_map. tauto.
  - intros t q I Q. apply in_map_iff in I. destruct I as (z & <- & I). unfold inside_triangles. split.
    + intros J. apply in_map_iff in J. destruct J as (y & E & J). apply filter_In in J. destruct J as [J K].
      apply (G y q J); [rewrite E|]; assumption.
    + intros K. apply in_map_iff. exists z. split; [reflexivity|]. apply filter_In. split; [assumption|].
      apply (G z q I Q). assumption.
Qed.
End Domain.
