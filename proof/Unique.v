(* Two lists of triangles that are right for the same points and edges, by the rule of the first corner, are the same.

   Where a triangle t of one list and a triangle v of the other overlap, take a point q of both interiors. The
   difference of the powers in the two circles is affine. Were it negative at q, it would be negative at a corner of t.
   That corner would be strictly inside the circle of v, and it is seen from q, because inside t no edge is in the way.
   So the difference is 0 wherever both are, and the circles are one. Then the rule says that no corner of one triangle
   lies strictly between the sides of the other that meet at the first corner; this leaves no room for a difference. *)
Require Import Reals ZArith List Lra Lia Psatz.
Require Import Spec Geometry Place Walk Cover Pieces.
Import ListNotations.
Open Scope R_scope.

Section Unique.
Variables (P : list point) (E : list edge).

Definition right (T : list triangle) : Prop := triangulation P E T /\ first_corner_rule P E T.

Lemma right_positive T t : right T -> In t T -> positive t.
Proof. intros [H _] I. destruct t as [[a b] c]. exact (turns_left _ _ _ H a b c I). Qed.

(* The point where two segments cross. *)
Lemma cross_point e f q p : cross e f q p -> exists s r, 0 < s < 1 /\ 0 < r < 1 /\ between q p s = between e f r.
Proof.
  intros [A B].
  set (D := orient e f q - orient e f p).
  assert (D0 : D <> 0) by (unfold D; nra).
  assert (F : orient q p e - orient q p f = - D) by (unfold D; flat; ring).
  assert (S : 0 < orient e f q / D < 1).
  { assert (G : orient e f q / D * (D * D) = orient e f q * D) by (field; assumption).
    assert (0 < D * D) by nra. assert (0 < orient e f q * D) by (unfold D; nra).
    assert (orient e f q * D < D * D) by (unfold D; nra). split; nra. }
  assert (R : 0 < orient q p e / - D < 1).
  { assert (G : orient q p e / - D * (D * D) = - (orient q p e * D)) by (field; assumption).
    assert (0 < D * D) by nra. assert (D = orient q p f - orient q p e) by lra.
    assert (0 < - (orient q p e * D)) by (rewrite H0; nra).
    assert (- (orient q p e * D) < D * D) by (rewrite H0; nra). split; nra. }
  exists (orient e f q / D), (orient q p e / - D). split; [assumption|]. split; [assumption|].
  unfold between. apply point_eq; cbn.
  - apply Rmult_eq_reg_l with D; [|assumption].
    replace (D * (X q + orient e f q / D * (X p - X q))) with (D * X q + orient e f q * (X p - X q)) by (field;
      assumption).
    replace (D * (X e + orient q p e / - D * (X f - X e))) with (D * X e - orient q p e * (X f - X e)) by (field;
      assumption).
    unfold D; flat; ring.
  - apply Rmult_eq_reg_l with D; [|assumption].
    replace (D * (Y q + orient e f q / D * (Y p - Y q))) with (D * Y q + orient e f q * (Y p - Y q)) by (field;
      assumption).
    replace (D * (Y e + orient q p e / - D * (Y f - Y e))) with (D * Y e - orient q p e * (Y f - Y e)) by (field;
      assumption).
    unfold D; flat; ring.
Qed.

Lemma no_overlap_same T t v q : right T -> In t T -> In v T -> in_interior q t -> in_interior q v -> t = v.
Proof.
  intros [H _] A B C D. apply In_nth_error in A, B. destruct A as [i A], B as [j B].
  destruct (Nat.eq_dec i j) as [->|N]; [congruence|]. exfalso. apply (no_overlap _ _ _ H i j t v q N A B). auto.
Qed.

(* Around a point inside t there is room, also inside a triangle to which the point belongs. *)
Lemma room t v x : positive v -> in_interior x t -> in_triangle x v -> exists y, in_interior y t /\ in_interior y v.
Proof.
  intros A I J. destruct t as [[a b] c]. pose proof I as I'. cbn in I'. destruct I' as (I1 & I2 & I3).
  destruct (soon_interior (a, b, c) x (middle v)) as (r & R & S); [left; lra|left; lra|left; lra|].
  exists (between x (middle v) r). split; [apply S; lra|].
  apply interior_between; try assumption. apply middle_interior; assumption.
Qed.

(* From inside a triangle its corners are seen. *)
Lemma corners_seen T t q p : right T -> In t T -> in_interior q t -> corner p t -> ~ blocked E q p.
Proof.
  intros HT I Q C (e & f & Ief & Cr). pose proof (right_positive T t HT I) as A.
  pose proof Cr as Cr'. apply cross_point in Cr'. destruct Cr' as (s & r & S & R & X).
  assert (N : e <> f).
  { intros ->. destruct Cr as [Cr _]. assert (orient f f q = 0) by (flat; ring). rewrite H in Cr. lra. }
  set (x := between q p s) in *.
  assert (Ix : in_interior x t).
  { replace x with (between p q (1 - s)) by (unfold x, between; apply point_eq; cbn; ring).
    apply interior_between; try assumption; [|lra]. apply corner_in_triangle; assumption. }
  destruct (edges_are_sides _ _ _ (proj1 HT) e f x Ief N) as (v & c & d & J & Sd & Sx & _).
  { exists r. split; [lra|assumption]. }
  pose proof (right_positive T v HT J) as B.
  apply side_turned in Sd. destruct Sd as [g Tv].
  pose proof (turned_positive _ _ _ _ Tv B) as B'.
  destruct Sx as [k [K Ex]].
  assert (Jx : in_triangle x v).
  { apply (turned_triangle _ _ _ _ _ Tv). rewrite Ex, !orient_between.
    destruct (orient_same c d) as [-> ->]. destruct (orient_same d g) as [-> _]. destruct (orient_same g c) as [_ ->].
    rewrite orient_turn. assert (F : orient g c d = orient c d g) by (symmetry; apply orient_turn). rewrite F.
    repeat split; nra. }
  destruct (room t v x B Ix Jx) as (y & Y1 & Y2).
  rewrite (no_overlap_same T t v y HT I J Y1 Y2) in Ix.
  apply (turned_interior _ _ _ _ _ Tv) in Ix. destruct Ix as (Z & _).
  rewrite Ex, orient_between in Z. destruct (orient_same c d) as [Z1 Z2]. rewrite Z1, Z2 in Z. lra.
Qed.

(* A corner of one triangle is not strictly inside the circle of another one that overlaps it. *)
Lemma power_not_less T U t v q o a w b : right T -> right U -> In t T -> In v U ->
  centre o t -> corner a t -> centre w v -> corner b v -> in_interior q t -> in_interior q v ->
  power o a q <= power w b q.
Proof.
  intros HT HU I J O Ca W Cb Q1 Q2. pose proof (right_positive T t HT I) as A.
  pose proof (right_positive U v HU J) as B.
  destruct (turned_exists t a Ca) as (a1 & a2 & Tt). destruct (turned_exists v b Cb) as (b1 & b2 & Tv).
  assert (G : 0 <= power w b q - power o a q); [|lra].
  rewrite power_difference. apply affine_in_triangle with t; [assumption|apply interior_closed; assumption|].
  intros p Cp. rewrite <- power_difference.
  assert (Zp : power o a p = 0).
  { apply (turned_centre _ _ _ _ _ Tt) in O. apply (turned_corner _ _ _ _ _ Tt) in Cp. unfold power.
    destruct Cp as [->|[->| ->]]; lra. }
  rewrite Zp. destruct (Rle_dec 0 (power w b p)) as [|N]; [lra|exfalso].
  apply (corners_seen T t q p HT I Q1 Cp).
  apply (delaunay _ _ _ (proj1 HU) v p q J).
  - apply (corners_given _ _ _ (proj1 HT) t p I Cp).
  - apply (in_circle_power v b b1 b2 w p B Tv W). lra.
  - assumption.
Qed.

Lemma one_circle T U t v q o a w b : right T -> right U -> In t T -> In v U ->
  centre o t -> corner a t -> centre w v -> corner b v -> in_interior q t -> in_interior q v ->
  forall p, power o a p = power w b p.
Proof.
  intros HT HU I J O Ca W Cb Q1 Q2 p. pose proof (right_positive T t HT I) as A.
  pose proof (right_positive U v HU J) as B.
  assert (Z : forall y, in_interior y t -> in_interior y v -> power o a y - power w b y = 0).
  { intros y Y1 Y2. pose proof (power_not_less T U t v y o a w b HT HU I J O Ca W Cb Y1 Y2).
    pose proof (power_not_less U T v t y w b o a HU HT J I W Cb O Ca Y2 Y1). lra. }
  assert (K : forall c, corner c t -> power o a c - power w b c = 0).
  { intros c Cc. pose proof (Z q Q1 Q2) as Zq.
    destruct v as [[x y] z]. pose proof Q2 as Q2'. cbn in Q2'. destruct Q2' as (V1 & V2 & V3).
    destruct (soon_interior (x, y, z) q c) as (r & R & S); [left; lra|left; lra|left; lra|].
    assert (S1 : in_interior (between q c (r / 2)) (x, y, z)) by (apply S; lra).
    assert (S2 : in_interior (between q c (r / 2)) t).
    { replace (between q c (r / 2)) with (between c q (1 - r / 2)) by (unfold between; apply point_eq; cbn; ring).
      apply interior_between; try assumption; [apply corner_in_triangle; assumption|lra]. }
    specialize (Z _ S2 S1). rewrite power_difference in Z, Zq |- *. rewrite affine_between, Zq in Z.
    assert (G : r / 2 * (power o a c - power w b c) = 0) by (rewrite power_difference; lra).
    apply Rmult_integral in G. rewrite power_difference in G. destruct G; [lra|assumption]. }
  assert (G : power o a p - power w b p = 0); [|lra].
  destruct t as [[x y] z]. pose proof (K x ltac:(cbn; auto)) as K1. pose proof (K y ltac:(cbn; auto)) as K2.
  pose proof (K z ltac:(cbn; auto)) as K3. rewrite power_difference in *. cbn in A.
  apply affine_zero with x y z; assumption.
Qed.

Lemma first_exists x l : exists y, In y (x :: l) /\ first_of y (x :: l).
Proof.
  revert x. induction l as [|z l IH]; intros x.
  - exists x. split; [left; reflexivity|]. intros b [<-|[]]; auto.
  - destruct (IH z) as (y & Iy & F). destruct (first_total x y) as [->|[L|L]].
    + exists y. split; [left; reflexivity|]. intros b [<-|H]; auto.
    + exists x. split; [left; reflexivity|]. intros b [<-|H]; auto.
      destruct (F b H) as [<-|G]; [auto|right; apply first_transitive with y; assumption].
    + exists y. split; [right; assumption|]. intros b [<-|H]; auto.
Qed.

(* The first corner of both is a corner of each. *)
Lemma first_is_shared T U t v q r : right T -> right U -> In t T -> In v U -> in_interior q t -> in_interior q v ->
  (forall p, corner p t -> on_circle p v) -> corner r t -> (forall x, corner x v -> r = x \/ first r x) -> corner r v.
Proof.
  intros HT HU I J Q1 Q2 On Cr F. pose proof (corners_given _ _ _ (proj1 HT) t r I Cr) as Hr.
  destruct (in_triangle_dec r v) as [Y|N]; [exact (no_point_within _ _ _ (proj1 HU) r v Hr J Y)|exfalso].
  assert (G : forall x y z, turned v x y z -> orient x y r < 0 -> False).
  { intros x y z Tv L. pose proof (turned_positive _ _ _ _ Tv (right_positive U v HU J)) as B.
    assert (Cx : corner x v) by (apply (turned_corner _ _ _ _ _ Tv); auto).
    assert (Cy : corner y v) by (apply (turned_corner _ _ _ _ _ Tv); auto).
    assert (Cz : corner z v) by (apply (turned_corner _ _ _ _ _ Tv); auto).
    destruct (orient_same x y) as [Ox Oy].
    destruct (proj2 HU v x y z r q J) as [K|[K|K]]; try assumption.
    - apply side_turned. exists z; assumption.
    - intros ->. lra.
    - intros ->. lra.
    - apply On; assumption.
    - exact (corners_seen T t q r HT I Q1 Cr K).
    - specialize (K r ltac:(cbn; auto)). specialize (F x Cx).
      destruct K as [->|K], F as [F|F]; try congruence; try lra; try (rewrite <- F in *; lra);
        exact (first_asymmetric _ _ K F).
    - specialize (K r ltac:(cbn; auto)). specialize (F y Cy).
      destruct K as [->|K], F as [F|F]; try congruence; try lra; try (rewrite <- F in *; lra);
        exact (first_asymmetric _ _ K F). }
  destruct v as [[x y] z] eqn:Ev. rewrite <- Ev in *.
  assert (Tv : turned v x y z) by (left; assumption).
  rewrite (turned_triangle _ _ _ _ _ Tv) in N.
  destruct (Rle_dec 0 (orient x y r)) as [N1|N1]; [|apply (G x y z); [assumption|lra]].
  destruct (Rle_dec 0 (orient y z r)) as [N2|N2]; [|apply (G y z x); [apply turned_next; assumption|lra]].
  destruct (Rle_dec 0 (orient z x r)) as [N3|N3]; [|apply (G z x y); [do 2 apply turned_next; assumption|lra]].
  auto.
Qed.

(* No corner of v is strictly between the sides of t that meet at the first corner r. *)
Lemma not_between T U t v q r b c e : right T -> right U -> In t T -> In v U -> in_interior q t -> in_interior q v ->
  turned t r b c -> corner e v -> on_circle e t -> (forall x, corner x t -> r = x \/ first r x) ->
  0 < orient r b e -> 0 < orient c r e -> False.
Proof.
  intros HT HU I J Q1 Q2 Tt Ce On F L1 L2.
  pose proof (turned_positive _ _ _ _ Tt (right_positive T t HT I)) as A.
  pose proof (corners_given _ _ _ (proj1 HU) v e J Ce) as He.
  assert (Cr : corner r t) by (apply (turned_corner _ _ _ _ _ Tt); auto).
  assert (Cb : corner b t) by (apply (turned_corner _ _ _ _ _ Tt); auto).
  assert (Cc : corner c t) by (apply (turned_corner _ _ _ _ _ Tt); auto).
  destruct (Rle_dec 0 (orient b c e)) as [P3|N].
  - assert (K : corner e t).
    { apply (no_point_within _ _ _ (proj1 HT) e t He I). apply (turned_triangle _ _ _ _ _ Tt). lra. }
    apply (turned_corner _ _ _ _ _ Tt) in K.
    destruct (orient_same r b) as [K1 K2]. destruct (orient_same c r) as [K3 _].
    destruct K as [->|[->| ->]]; lra.
  - destruct (orient_same r b) as [K1 K2]. destruct (orient_same c r) as [K3 K4]. destruct (orient_same b c) as [K5 K6].
    assert (Nb : r <> b) by (intros ->; flat; lra).
    assert (Nc : r <> c) by (intros ->; flat; lra).
    destruct (proj2 HT t b c r e q I) as [K|[K|K]]; try assumption; try lra.
    + apply side_turned. exists r. apply turned_next; assumption.
    + exact (corners_seen U v q e HU J Q2 Ce K).
    + specialize (K r ltac:(cbn; auto)). destruct (F b Cb) as [|G]; [auto|]. destruct K as [K|K]; [auto|].
      exact (first_asymmetric _ _ K G).
    + specialize (K r ltac:(cbn; auto)). destruct (F c Cc) as [|G]; [auto|]. destruct K as [K|K]; [auto|].
      exact (first_asymmetric _ _ K G).
Qed.

(* Two wedges at r that share a direction, neither of which has a side of the other strictly inside, begin together. *)
Lemma wedges_begin r b c e f q : 0 < orient r b c -> 0 < orient r e f ->
  0 < orient r b q -> 0 < orient c r q -> 0 < orient r e q -> 0 < orient f r q ->
  ~ (0 < orient r b e /\ 0 < orient c r e) -> ~ (0 < orient r e b /\ 0 < orient f r b) -> orient r b e = 0.
Proof.
  intros A B Q1 Q2 Q3 Q4 N1 N2.
  assert (S : orient r e b = - orient r b e) by (flat; ring). rewrite S in N2.
  assert (E1 : orient r b q * orient c r e = orient r b c * orient r e q + orient r b e * orient c r q)
    by (flat; ring).
  assert (E2 : orient r e q * orient f r b = orient r e f * orient r b q + - orient r b e * orient f r q)
    by (flat; ring).
  assert (P1 : 0 < orient r b c * orient r e q) by (apply Rmult_lt_0_compat; assumption).
  assert (P2 : 0 < orient r e f * orient r b q) by (apply Rmult_lt_0_compat; assumption).
  destruct (Rtotal_order (orient r b e) 0) as [L|[L|L]]; [exfalso|assumption|exfalso].
  - apply N2. split; [lra|].
    assert (0 < - orient r b e * orient f r q) by (apply Rmult_lt_0_compat; lra).
    apply Rmult_lt_reg_l with (orient r e q); lra.
  - apply N1. split; [lra|].
    assert (0 < orient r b e * orient c r q) by (apply Rmult_lt_0_compat; lra).
    apply Rmult_lt_reg_l with (orient r b q); lra.
Qed.

(* A line through a point of a circle meets the circle once more. *)
Lemma second_meeting o r b e : r <> b -> power o r b = 0 -> power o r e = 0 -> orient r b e = 0 -> e <> r -> e = b.
Proof.
  intros Nb B C Z N.
  assert (D : dist2 r b <> 0) by (intros D; apply dist2_zero in D; congruence).
  set (c := Point (X r - (Y b - Y r)) (Y r + (X b - X r))).
  assert (A : 0 < orient r b c).
  { assert (G : orient r b c = dist2 r b) by (unfold c, orient, dist2; cbn; ring). rewrite G.
    pose proof (dist2_nonneg r b). lra. }
  pose proof (on_side r b c e A Z) as H. set (s := orient c r e / orient r b c) in *.
  rewrite H, power_between, B in C. assert (K : power o r r = 0) by (unfold power; ring). rewrite K in C.
  assert (G : s * (1 - s) * dist2 r b = 0) by lra.
  apply Rmult_integral in G. destruct G as [G|G]; [|contradiction].
  apply Rmult_integral in G. destruct G as [G|G].
  - exfalso. apply N. rewrite H, G. unfold between; apply point_eq; cbn; ring.
  - rewrite H. replace s with 1 by lra. unfold between; apply point_eq; cbn; ring.
Qed.

Lemma overlapping_same T U t v q : right T -> right U -> In t T -> In v U -> in_interior q t -> in_interior q v ->
  same_triangle t v.
Proof.
  intros HT HU I J Q1 Q2. pose proof (right_positive T t HT I) as A. pose proof (right_positive U v HU J) as B.
  destruct t as [[a1 a2] a3] eqn:Et. rewrite <- Et in *. destruct v as [[b1 b2] b3] eqn:Ev. rewrite <- Ev in *.
  assert (Ta : turned t a1 a2 a3) by (left; assumption). assert (Tb : turned v b1 b2 b3) by (left; assumption).
  destruct (turned_centre_exists t A) as [o O]. destruct (turned_centre_exists v B) as [w W].
  assert (OC : forall p x y, corner x t -> corner y v -> power o x p = power w y p)
    by (intros p x y Cx Cy; apply (one_circle T U t v q o x w y); assumption).
  assert (Zt : forall x y, corner x t -> corner y t -> power o x y = 0).
  { intros x y Cx Cy. destruct (turned_exists t x Cx) as (x1 & x2 & Tx). apply (turned_centre _ _ _ _ _ Tx) in O.
    apply (turned_corner _ _ _ _ _ Tx) in Cy. unfold power. destruct Cy as [->|[->| ->]]; lra. }
  assert (Zv : forall x y, corner x v -> corner y v -> power w x y = 0).
  { intros x y Cx Cy. destruct (turned_exists v x Cx) as (x1 & x2 & Tx). apply (turned_centre _ _ _ _ _ Tx) in W.
    apply (turned_corner _ _ _ _ _ Tx) in Cy. unfold power. destruct Cy as [->|[->| ->]]; lra. }
  assert (Ca1 : corner a1 t) by (apply (turned_corner _ _ _ _ _ Ta); auto).
  assert (Cb1 : corner b1 v) by (apply (turned_corner _ _ _ _ _ Tb); auto).
  assert (Ont : forall p, corner p v -> on_circle p t).
  { intros p Cp. apply (on_circle_power t a1 a2 a3 o p A Ta O). rewrite (OC p a1 p Ca1 Cp). apply Zv; assumption. }
  assert (Onv : forall p, corner p t -> on_circle p v).
  { intros p Cp. apply (on_circle_power v b1 b2 b3 w p B Tb W). rewrite <- (OC p p b1 Cp Cb1). apply Zt; assumption. }
  destruct (first_exists a1 [a2; a3; b1; b2; b3]) as (r & Ir & Fr).
  assert (Ft : forall x, corner x t -> r = x \/ first r x).
  { intros x Cx. apply Fr. apply (turned_corner _ _ _ _ _ Ta) in Cx. cbn. intuition. }
  assert (Fv : forall x, corner x v -> r = x \/ first r x).
  { intros x Cx. apply Fr. apply (turned_corner _ _ _ _ _ Tb) in Cx. cbn. intuition. }
  assert (Cr : corner r t /\ corner r v).
  { assert (K : corner r t \/ corner r v).
    { rewrite (turned_corner _ _ _ _ _ Ta), (turned_corner _ _ _ _ _ Tb). cbn in Ir. intuition. }
    destruct K as [K|K]; split; try assumption.
    - apply (first_is_shared T U t v q r); assumption.
    - apply (first_is_shared U T v t q r); assumption. }
  destruct Cr as [Crt Crv].
  destruct (turned_exists t r Crt) as (b & c & Tt). destruct (turned_exists v r Crv) as (e & f & Tv).
  pose proof (turned_positive _ _ _ _ Tt A) as A'. pose proof (turned_positive _ _ _ _ Tv B) as B'.
  pose proof Q1 as Q1'. apply (turned_interior _ _ _ _ _ Tt) in Q1'. destruct Q1' as (R1 & _ & R2).
  pose proof Q2 as Q2'. apply (turned_interior _ _ _ _ _ Tv) in Q2'. destruct Q2' as (R3 & _ & R4).
  assert (Cb : corner b t) by (apply (turned_corner _ _ _ _ _ Tt); auto).
  assert (Cc : corner c t) by (apply (turned_corner _ _ _ _ _ Tt); auto).
  assert (Ce : corner e v) by (apply (turned_corner _ _ _ _ _ Tv); auto).
  assert (Cf : corner f v) by (apply (turned_corner _ _ _ _ _ Tv); auto).
  assert (NB : forall x, corner x v -> ~ (0 < orient r b x /\ 0 < orient c r x)).
  { intros x Cx [L1 L2]. apply (not_between T U t v q r b c x); try assumption. apply Ont; assumption. }
  assert (NE : forall x, corner x t -> ~ (0 < orient r e x /\ 0 < orient f r x)).
  { intros x Cx [L1 L2]. apply (not_between U T v t q r e f x); try assumption. apply Onv; assumption. }
  assert (Z1 : orient r b e = 0) by (apply (wedges_begin r b c e f q); auto).
  assert (Z2 : orient r c f = 0).
  { (* the same, seen in a mirror *)
    pose (mi := fun p : point => Point (X p) (- Y p)).
    assert (M : forall x y z, orient (mi x) (mi y) (mi z) = - orient x y z) by (intros; unfold mi, orient; cbn; ring).
    assert (Sw : forall x y, orient r x y = - orient r y x) by (intros; flat; ring).
    assert (St : forall x y, orient x r y = - orient r x y) by (intros; flat; ring).
    assert (G : orient (mi r) (mi c) (mi f) = 0); [|rewrite M in G; lra].
    pose proof (NB f Cf) as NBf. pose proof (NE c Cc) as NEc.
    rewrite St in R2, R4, NBf, NEc.
    apply (wedges_begin (mi r) (mi c) (mi b) (mi f) (mi e) (mi q)); rewrite ?M, ?St; try lra;
      rewrite ?(Sw c b), ?(Sw f e); lra. }
  assert (Ne : e <> r) by (intros ->; assert (orient r r f = 0) by (flat; ring); lra).
  assert (Nf : f <> r) by (intros ->; destruct (orient_same r e); lra).
  assert (Pe : power o r e = 0) by (rewrite (OC e r r Crt Crv); apply Zv; assumption).
  assert (Pf : power o r f = 0) by (rewrite (OC f r r Crt Crv); apply Zv; assumption).
  assert (Nb : r <> b) by (intros ->; assert (orient b b c = 0) by (flat; ring); lra).
  assert (Nc : r <> c) by (intros ->; destruct (orient_same c b); lra).
  assert (Eb : e = b) by (apply (second_meeting o r b e); auto).
  assert (Ec : f = c) by (apply (second_meeting o r c f); auto).
  subst e f. intros p. rewrite (turned_corner _ _ _ _ _ Tt), (turned_corner _ _ _ _ _ Tv). tauto.
Qed.

Lemma overlapping_exists T U t : right T -> right U -> In t T ->
  exists v q, In v U /\ in_interior q t /\ in_interior q v.
Proof.
  intros HT HU I. pose proof (right_positive T t HT I) as A. pose proof (middle_interior t A) as M.
  destruct (proj1 (covers_hull _ _ _ (proj1 HU) (middle t))) as (v & J & Q).
  - apply (covers_hull _ _ _ (proj1 HT)). exists t. split; [assumption|apply interior_closed; assumption].
  - destruct (room t v (middle t) (right_positive U v HU J) M Q) as (q & Q1 & Q2). exists v, q. auto.
Qed.

Lemma right_within T U t : right T -> right U -> In t T -> exists v, In v U /\ same_triangle t v.
Proof.
  intros HT HU I. destruct (overlapping_exists T U t HT HU I) as (v & q & J & Q1 & Q2).
  exists v. split; [assumption|]. apply (overlapping_same T U t v q); assumption.
Qed.

Lemma right_unique T U : right T -> right U -> same_triangles T U.
Proof.
  intros HT HU. split; intros t I.
  - apply (right_within T U); assumption.
  - destruct (right_within U T t HU HT I) as (v & J & S). exists v. split; [assumption|].
    intros p. symmetry. apply S.
Qed.
End Unique.

(* What stands in the lists counts, not the order, nor how often, nor the direction of an edge. *)
Lemma same_points_hull P Q q : same_points P Q -> in_hull P q -> in_hull Q q.
Proof. intros S H u v w L. apply H. intros p I. apply L. apply S. assumption. Qed.

Lemma cross_swap a b q p : cross a b q p -> cross b a q p.
Proof.
  unfold cross. rewrite (orient_swap a b q), (orient_swap a b p). intros [A B]. split; lra.
Qed.

Lemma same_edges_blocked E F q p : same_edges E F -> blocked E q p -> blocked F q p.
Proof.
  intros S (a & b & I & C). destruct (proj1 (S a b) (or_introl I)) as [J|J].
  - exists a, b. auto.
  - exists b, a. split; [assumption|apply cross_swap; assumption].
Qed.

Lemma same_points_symmetric P Q : same_points P Q -> same_points Q P.
Proof. intros S p. symmetry. apply S. Qed.
Lemma same_edges_symmetric E F : same_edges E F -> same_edges F E.
Proof. intros S a b. symmetry. apply S. Qed.

Lemma right_same P E Q F T : same_points P Q -> same_edges E F -> right P E T -> right Q F T.
Proof.
  intros SP SE [H K]. pose proof (same_points_symmetric _ _ SP) as SP'. pose proof (same_edges_symmetric _ _ SE) as SE'.
  split; [split|].
  - apply (turns_left _ _ _ H).
  - intros t p I C. apply SP. apply (corners_given _ _ _ H t p I C).
  - apply (no_overlap _ _ _ H).
  - intros q. rewrite <- (covers_hull _ _ _ H q). split; apply same_points_hull; assumption.
  - intros p I. apply (all_corners _ _ _ H). apply SP. assumption.
  - intros p t I. apply (no_point_within _ _ _ H). apply SP. assumption.
  - intros a b q I N S. destruct (proj2 (SE a b) (or_introl I)) as [J|J].
    + apply (edges_are_sides _ _ _ H); assumption.
    + destruct (edges_are_sides _ _ _ H b a q J) as (t & c & d & It & Sd & Q0 & C & D); auto using on_segment_swap.
      exists t, c, d. auto 10 using on_segment_swap.
  - intros t p q I J C D. apply (same_edges_blocked E); [assumption|].
    apply (delaunay _ _ _ H t p q); try assumption. apply SP. assumption.
  - intros t a b c p q I Sd Cc Na Nb J C N D.
    destruct (K t a b c p q I Sd Cc Na Nb (proj2 (SP p) J) C N D) as [B|B]; [left|right; assumption].
    apply (same_edges_blocked E); assumption.
Qed.

Theorem canonical_unique P E Q F T U : same_points P Q -> same_edges E F ->
  canonical P E T -> canonical Q F U -> same_triangles T U.
Proof.
  intros SP SE [HT KT] [HU KU].
  assert (G : forall P Q E T (U : list triangle), same_points P Q -> triangulation P E T ->
    on_one_line Q /\ U = [] -> T = []).
  { clear. intros P Q E T U S H [L ->]. destruct T as [|[[a b] c] T]; [reflexivity|exfalso].
    pose proof (turns_left _ _ _ H a b c (or_introl eq_refl)) as A.
    assert (I : forall p, corner p (a, b, c) -> In p Q)
      by (intros p C; apply S; apply (corners_given _ _ _ H (a, b, c) p (or_introl eq_refl) C)).
    rewrite (L a b c) in A by (apply I; cbn; auto). lra. }
  destruct HT as [HT|HT], HU as [HU|HU].
  - apply (right_unique Q F); [|split; assumption]. apply (right_same P E); auto. split; assumption.
  - rewrite (G P Q E T U SP HT HU). destruct HU as [_ ->]. split; intros t [].
  - rewrite (G Q P F U T (same_points_symmetric _ _ SP) HU HT). destruct HT as [_ ->]. split; intros t [].
  - destruct HT as [_ ->], HU as [_ ->]. split; intros t [].
Qed.
