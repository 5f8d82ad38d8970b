(* From integers to real points: coordinates are integers times a positive unit. Signs are the same on both sides. *)
Require Import Reals ZArith List Lra Lia Bool.
Require Import Spec Geometry Check.
Import ListNotations.
Open Scope R_scope.

Definition place (u : R) (p : zpoint) : point := Point (u * IZR (zx p)) (u * IZR (zy p)).
Definition place_triangle (u : R) (t : ztriangle) : triangle :=
  (place u (corner_a t), place u (corner_b t), place u (corner_c t)).
Definition place_edge (u : R) (e : zedge) : edge := (place u (edge_from e), place u (edge_to e)).

(* The order of the sweep from left to right. *)
Definition lex (a b : point) : Prop := X a < X b \/ (X a = X b /\ Y a < Y b).

Lemma compare_points_eq a b : compare_points a b = Eq -> a = b.
Proof.
  unfold compare_points. destruct a as [ax ay], b as [bx by_]; cbn.
  destruct (Z.compare_spec ax bx); try discriminate. destruct (Z.compare_spec ay by_); try discriminate.
  intros; subst; reflexivity.
Qed.

Lemma compare_sides_eq s t : compare_sides s t = Eq -> s = t.
Proof.
  unfold compare_sides. destruct s as [a b], t as [c d]; cbn.
  destruct (compare_points a c) eqn:E; try discriminate. intros F.
  apply compare_points_eq in E, F. subst; reflexivity.
Qed.

Lemma same_eq a b : same a b = true -> a = b.
Proof. unfold same. destruct (compare_points a b) eqn:E; try discriminate.
intros; apply compare_points_eq; assumption. Qed.

Lemma same_refl a : same a a = true.
Proof. unfold same, compare_points. rewrite !Z.compare_refl. reflexivity. Qed.

Lemma before_spec a b : before a b = true <-> (zx a < zx b \/ (zx a = zx b /\ zy a < zy b))%Z.
Proof.
  unfold before, compare_points. destruct (Z.compare_spec (zx a) (zx b)), (Z.compare_spec (zy a) (zy b));
    split; intros; try discriminate; try reflexivity; lia.
Qed.

Lemma compare_points_lt a b c : compare_points a b = Lt -> compare_points b c = Lt -> compare_points a c = Lt.
Proof.
  assert (E : forall a b, compare_points a b = Lt <-> before a b = true).
  { intros x y. unfold before. destruct (compare_points x y); split; congruence. }
  rewrite !E, !before_spec. lia.
Qed.

Lemma compare_points_same a : compare_points a a <> Lt.
Proof. unfold compare_points. rewrite !Z.compare_refl. discriminate. Qed.

Section Place.
Variable u : R.
Hypothesis u_positive : 0 < u.

Lemma unit_eq x y : u * IZR x = u * IZR y <-> x = y.
Proof. split; [|intros; subst; reflexivity]. intros H. apply Rmult_eq_reg_l in H; [apply eq_IZR; assumption|lra]. Qed.

Lemma unit_lt x y : u * IZR x < u * IZR y <-> (x < y)%Z.
Proof.
  split; intros H.
  - apply lt_IZR. apply Rmult_lt_reg_l with u; assumption.
  - apply Rmult_lt_compat_l; [assumption|]. apply IZR_lt; assumption.
Qed.

Lemma place_injective a b : place u a = place u b -> a = b.
Proof.
  destruct a, b. unfold place; cbn. intros H. injection H as Hx Hy.
  apply -> unit_eq in Hx. apply -> unit_eq in Hy. subst; reflexivity.
Qed.

Lemma before_lex a b : before a b = true <-> lex (place u a) (place u b).
Proof.
  unfold before, compare_points, lex, place; cbn. rewrite !unit_lt, unit_eq.
  destruct (Z.compare_spec (zx a) (zx b)); [|split; [auto|reflexivity]|split; [discriminate|lia]].
  destruct (Z.compare_spec (zy a) (zy b)); (split; [|auto; lia]); auto; discriminate.
Qed.

Lemma not_before a b : before a b = false -> a = b \/ lex (place u b) (place u a).
Proof.
  intros H. destruct (compare_points a b) eqn:E.
  - left; apply compare_points_eq; assumption.
  - unfold before in H. rewrite E in H. discriminate.
  - right. unfold compare_points in E. unfold lex, place; cbn. rewrite !unit_lt, unit_eq.
    destruct (Z.compare_spec (zx a) (zx b)); try discriminate; [|left; assumption].
    destruct (Z.compare_spec (zy a) (zy b)); try discriminate. right; auto.
Qed.

Lemma place_orient a b c : orient (place u a) (place u b) (place u c) = u * u * IZR (zorient a b c).
Proof. unfold orient, zorient, place; cbn. rewrite minus_IZR, !mult_IZR, !minus_IZR. ring. Qed.

Lemma place_orient_positive a b c : (0 < zorient a b c)%Z <-> 0 < orient (place u a) (place u b) (place u c).
Proof.
  rewrite place_orient. assert (0 < u * u) by nra. split; intros.
  - apply Rmult_lt_0_compat; [assumption|]. apply IZR_lt; assumption.
  - apply lt_IZR. apply Rmult_lt_reg_l with (u * u); lra.
Qed.

Lemma place_orient_nonneg a b c : (0 <= zorient a b c)%Z <-> 0 <= orient (place u a) (place u b) (place u c).
Proof.
  rewrite place_orient. assert (0 < u * u) by nra. split; intros.
  - apply Rmult_le_pos; [lra|]. apply IZR_le; assumption.
  - apply le_IZR. apply Rmult_le_reg_l with (u * u); lra.
Qed.

Lemma place_orient_zero a b c : (zorient a b c = 0)%Z <-> orient (place u a) (place u b) (place u c) = 0.
Proof.
  rewrite place_orient. assert (0 < u * u) by nra. split; intros E.
  - rewrite E. ring.
  - apply eq_IZR. apply Rmult_eq_reg_l with (u * u); lra.
Qed.

Lemma place_circle a b c p : circle (place u a) (place u b) (place u c) (place u p)
  = u * u * (u * u) * IZR (zcircle a b c p).
Proof.
  unfold circle, zcircle, place; cbn.
  rewrite !plus_IZR, !mult_IZR, !minus_IZR, !plus_IZR, !mult_IZR, !minus_IZR. ring.
Qed.

Lemma zfirst_first a b : zfirst a b = true <-> place u a = place u b \/ first (place u a) (place u b).
Proof.
  unfold zfirst, first.
  assert (Gt_ : Y (place u a) > Y (place u b) <-> (zy b < zy a)%Z) by (unfold place, Rgt; cbn; apply unit_lt).
  rewrite Gt_. unfold place at 3 4 5 6; cbn [X]. rewrite unit_lt, unit_eq.
  assert (E : place u a = place u b <-> zx a = zx b /\ zy a = zy b).
  { split; intros H.
    - apply place_injective in H; subst; auto.
    - destruct a, b; cbn in H; destruct H; subst; reflexivity. }
  rewrite E.
  destruct (Z.compare_spec (zx a) (zx b)); rewrite ?Z.leb_le; split; intros; try reflexivity; try discriminate; lia.
Qed.
End Place.

(* The corner that is first of three or four. *)
Lemma first_transitive a b c : first a b -> first b c -> first a c.
Proof. unfold first. lra. Qed.

Lemma first_total a b : a = b \/ first a b \/ first b a.
Proof.
  unfold first. destruct (Rtotal_order (X a) (X b)) as [|[E|]]; [lra| |lra].
  destruct (Rtotal_order (Y a) (Y b)) as [|[F|]]; [lra| |lra]. left. apply point_eq; assumption.
Qed.

Lemma lex_total a b : a = b \/ lex a b \/ lex b a.
Proof.
  unfold lex. destruct (Rtotal_order (X a) (X b)) as [|[E|]]; [lra| |lra].
  destruct (Rtotal_order (Y a) (Y b)) as [|[F|]]; [lra| |lra]. left. apply point_eq; assumption.
Qed.

Lemma lex_transitive a b c : lex a b -> lex b c -> lex a c.
Proof. unfold lex. lra. Qed.

Lemma lex_irreflexive a : ~ lex a a.
Proof. unfold lex. lra. Qed.
