(* An edge is the union of its pieces. *)
Require Import Reals ZArith List Lra Lia Bool.
Require Import Spec Geometry Check Place.
Import ListNotations.
Open Scope R_scope.

Lemma on_segment_left a b : on_segment a a b.
Proof. exists 0. split; [lra|]. unfold between. apply point_eq; cbn; ring. Qed.

Lemma on_segment_right a b : on_segment b a b.
Proof. exists 1. split; [lra|]. unfold between. apply point_eq; cbn; ring. Qed.

Lemma on_segment_swap q a b : on_segment q a b -> on_segment q b a.
Proof.
  intros [s [S ->]]. exists (1 - s). split; [lra|]. unfold between. apply point_eq; cbn; ring.
Qed.

Lemma on_segment_within q v a b : on_segment v a b -> on_segment q v b -> on_segment q a b.
Proof.
  intros [s [S ->]] [r [R ->]]. exists (s + r - r * s). split; [nra|]. symmetry. apply between_between.
Qed.

Lemma on_segment_split q v a b : on_segment v a b -> on_segment q a b -> on_segment q a v \/ on_segment q v b.
Proof.
  intros [s [S ->]] [t [T ->]]. destruct (Rle_dec t s) as [L|L].
  - left. destruct (Req_dec s 0) as [->|N].
    + exists 0. split; [lra|]. assert (t = 0) by lra. subst t. unfold between; apply point_eq; cbn; ring.
    + exists (t / s). split.
      * split; [apply Rmult_le_reg_r with s | apply Rmult_le_reg_r with s]; try lra;
        unfold Rdiv; rewrite Rmult_assoc, Rinv_l by assumption; lra.
      * unfold between; apply point_eq; cbn; field; assumption.
  - right. assert (N : 1 - s <> 0) by lra. exists ((t - s) / (1 - s)). split.
    + split; [apply Rmult_le_reg_r with (1 - s) | apply Rmult_le_reg_r with (1 - s)]; try lra;
      unfold Rdiv; rewrite Rmult_assoc, Rinv_l by assumption; lra.
    + unfold between; apply point_eq; cbn; field; assumption.
Qed.

Lemma on_segment_lex a v b : orient a b v = 0 -> lex a v -> lex v b -> on_segment v a b.
Proof.
  intros O A B. unfold orient in O. unfold lex in *.
  destruct (Req_dec (X a) (X b)) as [E|N].
  - assert (X v = X a) by lra. exists ((Y v - Y a) / (Y b - Y a)). split.
    + split; [apply Rmult_le_reg_r with (Y b - Y a) | apply Rmult_le_reg_r with (Y b - Y a)]; try lra;
      unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra.
    + unfold between; apply point_eq; cbn; [rewrite E; lra|field; lra].
  - exists ((X v - X a) / (X b - X a)). split.
    + split; [apply Rmult_le_reg_r with (X b - X a) | apply Rmult_le_reg_r with (X b - X a)]; try lra;
      unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra.
    + unfold between; apply point_eq; cbn; [field; lra|].
      assert (D : X b - X a <> 0) by lra. apply Rmult_eq_reg_l with (X b - X a); [|assumption].
      replace ((X b - X a) * (Y a + (X v - X a) / (X b - X a) * (Y b - Y a)))
        with ((X b - X a) * Y a + (X v - X a) * (Y b - Y a)) by (field; assumption). lra.
Qed.

Section Pieces.
Variable u : R.
Hypothesis u_positive : 0 < u.
Notation left_of s := (place u (left_end s)).
Notation right_of s := (place u (right_end s)).

Definition piece_at (x : zside) (q a b : point) : Prop :=
  on_segment q (left_of x) (right_of x) /\ on_segment (left_of x) a b /\ on_segment (right_of x) a b.

Lemma piece_covers a b q : on_segment q (place u a) (place u b) -> piece_at (piece a b) q (place u a) (place u b).
Proof.
  intros H. unfold piece, piece_at. destruct (before a b); cbn; repeat split;
    auto using on_segment_left, on_segment_right, on_segment_swap.
Qed.

Lemma inside_on_segment a v b : inside a v b = true -> on_segment (place u v) (place u a) (place u b).
Proof.
  unfold inside. intros H. apply andb_prop in H. destruct H as [O H]. apply Z.eqb_eq in O.
  apply (place_orient_zero u u_positive) in O.
  apply orb_prop in H. destruct H as [H|H]; apply andb_prop in H; destruct H as [A B];
    apply (before_lex u u_positive) in A, B.
  - apply on_segment_lex; assumption.
  - apply on_segment_swap. apply on_segment_lex; try assumption.
    unfold orient in *. lra.
Qed.

Lemma pieces_of_spec b : forall through a acc l, pieces_of a through b acc = Some l ->
  incl acc l /\
  (forall x, In x l -> In x acc \/
     (on_segment (left_of x) (place u a) (place u b) /\ on_segment (right_of x) (place u a) (place u b))) /\
  (forall q, on_segment q (place u a) (place u b) -> exists x, In x l /\ piece_at x q (place u a) (place u b)).
Proof.
  induction through as [|v r IH]; cbn; intros a acc l H.
  - injection H as <-. split; [apply incl_tl, incl_refl|]. split.
    + intros x [<-|I]; [right|left; assumption].
      destruct (piece_covers a b _ (on_segment_left _ _)) as (_ & ? & ?). auto.
    + intros q Q. exists (piece a b). split; [left; reflexivity|]. apply piece_covers; assumption.
  - destruct (inside a v b) eqn:V; [|discriminate]. apply inside_on_segment in V.
    destruct (IH _ _ _ H) as (I & O & C).
    assert (F : forall x, on_segment (place u x) (place u a) (place u v) ->
      on_segment (place u x) (place u a) (place u b)).
    { intros x S. apply on_segment_swap. apply on_segment_within with (place u v); apply on_segment_swap; assumption. }
    split; [|split].
    + intros x Hx. apply I. right; assumption.
    + intros x Hx. destruct (O x Hx) as [[<-|A]|[A B]]; [right| left; assumption| right].
      * destruct (piece_covers a v _ (on_segment_left _ _)) as (_ & ? & ?). split; apply F; assumption.
      * split; apply on_segment_within with (place u v); assumption.
    + intros q Q. destruct (on_segment_split _ _ _ _ V Q) as [S|S].
      * exists (piece a v). split; [apply I; left; reflexivity|].
        destruct (piece_covers a v q S) as (? & ? & ?). split; [assumption|]. split; apply F; assumption.
      * destruct (C q S) as (x & Ix & P & P1 & P2). exists x. split; [assumption|]. split; [assumption|].
        split; apply on_segment_within with (place u v); assumption.
Qed.

Lemma pieces_spec : forall es acc l, pieces es acc = Some l ->
  incl acc l /\
  (forall x, In x l -> In x acc \/ exists a b, In (a, b) (map (place_edge u) es) /\
     on_segment (left_of x) a b /\ on_segment (right_of x) a b) /\
  (forall a b q, In (a, b) (map (place_edge u) es) -> a <> b -> on_segment q a b ->
     exists x, In x l /\ piece_at x q a b).
Proof.
  induction es as [|e r IH]; cbn; intros acc l H.
  - injection H as <-. repeat split; auto using incl_refl. intros a b q [].
  - destruct (same (edge_from e) (edge_to e)) eqn:S.
    + apply same_eq in S. destruct (IH _ _ H) as (I & O & C). split; [assumption|]. split.
      * intros x Hx. destruct (O x Hx) as [|(a & b & A & B)]; [auto|]. right. exists a, b. auto.
      * intros a b q [E|J] N Q; [|apply C; assumption].
        unfold place_edge in E. injection E as <- <-. rewrite S in N. congruence.
    + destruct (pieces_of _ _ _ acc) as [acc'|] eqn:P; [|discriminate].
      destruct (IH _ _ H) as (I & O & C). destruct (pieces_of_spec _ _ _ _ _ P) as (I' & O' & C').
      split; [apply incl_tran with acc'; assumption|]. split.
      * intros x Hx. destruct (O x Hx) as [A|(a & b & A & B)].
        -- destruct (O' x A) as [|[L M]]; [auto|]. right.
           exists (place u (edge_from e)), (place u (edge_to e)). split; [left; reflexivity|auto].
        -- right. exists a, b. auto.
      * intros a b q [E|J] N Q; [|apply C; assumption].
        unfold place_edge in E. injection E as <- <-. destruct (C' q Q) as (x & A & B). exists x. auto.
Qed.
End Pieces.
