(* The triangles cover the hull, none overlaps another, and points are at corners only. *)
Require Import Reals ZArith List Lra Lia Psatz.
Require Import Spec Geometry Count Tiling.
Import ListNotations.
Open Scope R_scope.

(* What is positive at the beginning of a segment, or 0 there and positive at its end, is positive soon after. *)
Definition soon (f g : R) : Prop := 0 < f \/ (f = 0 /\ 0 < g).

Lemma soon_positive f g : soon f g -> exists r, 0 < r <= 1 /\ forall s, 0 < s <= r -> 0 < (1 - s) * f + s * g.
Proof.
  intros [F|[-> G]].
  - pose proof (Rabs_pos g) as B. pose proof (Rle_abs (- g)) as C. rewrite Rabs_Ropp in C.
    set (d := 2 * (f + Rabs g)). assert (D : 0 < d) by (unfold d; lra).
    exists (f / d). assert (E : f / d * d = f) by (field; lra).
    split.
    + split; [apply Rdiv_lt_0_compat; lra|]. apply Rmult_le_reg_r with d; [assumption|]. rewrite E. unfold d; lra.
    + intros s [S1 S2].
      assert (s * d <= f / d * d) by (apply Rmult_le_compat_r; lra).
      assert (s * (- g) <= s * Rabs g) by (apply Rmult_le_compat_l; lra). unfold d in *; lra.
  - exists 1. split; [lra|]. intros s S. assert (0 < s * g) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma soon_interior t p z : let '(a, b, c) := t in
  soon (orient a b p) (orient a b z) -> soon (orient b c p) (orient b c z) -> soon (orient c a p) (orient c a z) ->
  exists r, 0 < r <= 1 /\ forall s, 0 < s <= r -> in_interior (between p z s) t.
Proof.
  destruct t as [[a b] c]. intros A B C.
  apply soon_positive in A, B, C. destruct A as (r1 & R1 & A), B as (r2 & R2 & B), C as (r3 & R3 & C).
  exists (Rmin r1 (Rmin r2 r3)).
  pose proof (Rmin_l r1 (Rmin r2 r3)); pose proof (Rmin_r r1 (Rmin r2 r3)).
  pose proof (Rmin_l r2 r3); pose proof (Rmin_r r2 r3). split.
  - split; [repeat apply Rmin_glb_lt; lra | lra].
  - intros s S. cbn. rewrite !orient_between. repeat split; [apply A|apply B|apply C]; lra.
Qed.

Lemma turned_soon t a b c p z : turned t a b c ->
  soon (orient a b p) (orient a b z) -> soon (orient b c p) (orient b c z) -> soon (orient c a p) (orient c a z) ->
  exists r, 0 < r <= 1 /\ forall s, 0 < s <= r -> in_interior (between p z s) t.
Proof.
  intros T A B C. destruct (soon_interior (a, b, c) p z A B C) as (r & R & H). exists r. split; [assumption|].
  intros s S. specialize (H s S). rewrite (turned_interior _ _ _ _ _ T). exact H.
Qed.

(* A point outside of all triangles has a neighbourhood outside of them. *)
Lemma in_triangle_dec q t : {in_triangle q t} + {~ in_triangle q t}.
Proof.
  destruct t as [[a b] c]; cbn.
  destruct (Rle_dec 0 (orient a b q)), (Rle_dec 0 (orient b c q)), (Rle_dec 0 (orient c a q)); try (left; tauto);
    right; tauto.
Qed.

Lemma outside_soon q z t : ~ in_triangle q t ->
  exists r, 0 < r <= 1 /\ forall s, 0 < s <= r -> ~ in_triangle (between q z s) t.
Proof.
  destruct t as [[a b] c]; cbn. intros N.
  assert (G : forall x y, orient x y q < 0 ->
    exists r, 0 < r <= 1 /\ forall s, 0 < s <= r -> orient x y (between q z s) < 0).
  { intros x y O. destruct (soon_positive (- orient x y q) (- orient x y z)) as (r & R & H); [left; lra|].
    exists r. split; [assumption|]. intros s S. specialize (H s S). rewrite orient_between. lra. }
  destruct (Rle_dec 0 (orient a b q)); [destruct (Rle_dec 0 (orient b c q))|].
  - destruct (G c a) as (r1 & R & H); [|exists r1; split; [assumption|]; intros s S; specialize (H s S); lra].
    destruct (Rle_dec 0 (orient c a q)); [tauto|lra].
  - destruct (G b c) as (r1 & R & H); [lra|exists r1; split; [assumption|]; intros s S; specialize (H s S); lra].
  - destruct (G a b) as (r1 & R & H); [lra|exists r1; split; [assumption|]; intros s S; specialize (H s S); lra].
Qed.

Lemma outside_all_soon q z : forall T, (forall t, In t T -> ~ in_triangle q t) ->
  exists r, 0 < r <= 1 /\ forall s t, 0 < s <= r -> In t T -> ~ in_triangle (between q z s) t.
Proof.
  induction T as [|t T IH]; intros H.
  - exists 1. split; [lra|]. intros s t _ [].
  - destruct IH as (r & R & F); [intros; apply H; right; assumption|].
    destruct (outside_soon q z t) as (r' & R' & F'); [apply H; left; reflexivity|].
    exists (Rmin r r'). pose proof (Rmin_l r r'); pose proof (Rmin_r r r').
    split; [split; [apply Rmin_glb_lt; lra|lra]|].
    intros s t' S [<-|I]; [apply F'|apply F]; try assumption; lra.
Qed.

Lemma covered_or_not q T : (exists t, In t T /\ in_triangle q t) \/ (forall t, In t T -> ~ in_triangle q t).
Proof.
  induction T as [|t T IH]; [right; intros t []|].
  destruct (in_triangle_dec q t) as [Y|N]; [left; exists t; cbn; auto|].
  destruct IH as [(t' & I & Y)|H]; [left; exists t'; cbn; auto|]. right. intros t' [<-|I]; auto.
Qed.

Section Cover.
Variables (rule : bool) (P : list point) (E : list edge) (T : list triangle).
Hypothesis H : tiled rule P E T.

Lemma count_nonneg q t : In t T -> (0 <= count q t)%Z.
Proof. intros I. destruct (count_triangle q t (t_positive _ _ _ _ H t I)) as (? & _). lia. Qed.

Lemma tiled_no_overlap i j t v q : i <> j -> nth_error T i = Some t -> nth_error T j = Some v ->
  ~ (in_interior q t /\ in_interior q v).
Proof.
  intros N A B [C D].
  pose proof (total_two (count q) T (count_nonneg q) i j t v N A B).
  pose proof (t_once _ _ _ _ H q).
  apply nth_error_In in A, B.
  apply (count_triangle q t (t_positive _ _ _ _ H t A)) in C.
  apply (count_triangle q v (t_positive _ _ _ _ H v B)) in D. lia.
Qed.

Lemma tiled_unique t v q : In t T -> In v T -> in_interior q t -> in_interior q v -> t = v.
Proof.
  intros A B C D. apply In_nth_error in A, B. destruct A as [i A], B as [j B].
  destruct (Nat.eq_dec i j) as [->|N]; [congruence|]. exfalso. apply (tiled_no_overlap i j t v q N A B). auto.
Qed.

Lemma value_affine g : exists k m w, forall q, value_at g q = affine k m w q.
Proof. destruct g as [[k m] w]. exists k, m, w. reflexivity. Qed.

Lemma frame_inside g t q : (forall p, In p P -> 0 <= value_at g p) -> (exists z, value_at g z <> 0) ->
  In t T -> in_interior q t -> 0 < value_at g q.
Proof.
  intros G [z Z] I Q. destruct g as [[k m] w]. cbn [value_at] in *.
  assert (C : forall p, corner p t -> 0 <= affine k m w p)
    by (intros p C; apply G; apply (t_corners _ _ _ _ H) with t; assumption).
  apply affine_in_interior with t; try assumption.
  pose proof (t_positive _ _ _ _ H t I) as A. destruct t as [[a b] c]; cbn in A.
  destruct (Rlt_dec 0 (affine k m w a)); [exists a; cbn; auto|].
  destruct (Rlt_dec 0 (affine k m w b)); [exists b; cbn; auto|].
  destruct (Rlt_dec 0 (affine k m w c)); [exists c; cbn; auto|].
  exfalso. apply Z. pose proof (C a ltac:(cbn; auto)). pose proof (C b ltac:(cbn; auto)).
  pose proof (C c ltac:(cbn; auto)).
  apply affine_zero with a b c; lra.
Qed.

Lemma tiled_hull q : in_hull P q <-> exists t, In t T /\ in_triangle q t.
Proof.
  split.
  - intros Q. destruct (covered_or_not q T) as [|N]; [assumption|exfalso].
    destruct (t_some _ _ _ _ H) as [t0 I0]. pose proof (t_positive _ _ _ _ H t0 I0) as A0.
    destruct (outside_all_soon q (middle t0) T N) as (r & R & F).
    destruct (t_frame _ _ _ _ H) as (G & GP & GC).
    assert (C : (0 < total (count (between q (middle t0) r)) T)%Z).
    { apply GC. intros g Ig. destruct (GP g Ig) as [G0 G1].
      pose proof (frame_inside g t0 (middle t0) G0 G1 I0 (middle_interior _ A0)) as GM.
      assert (GQ : 0 <= value_at g q).
      { destruct g as [[k m] w]. cbn [value_at] in *. unfold affine in *.
        specialize (Q (- k) (- m) w). assert (- k * X q + - m * Y q <= w); [|lra].
        apply Q. intros p Hp. specialize (G0 p Hp). lra. }
      destruct g as [[k m] w]. cbn [value_at] in *. rewrite affine_between.
      assert (0 <= (1 - r) * affine k m w q) by (apply Rmult_le_pos; lra).
      assert (0 < r * affine k m w (middle t0)) by (apply Rmult_lt_0_compat; lra). lra. }
    apply total_positive in C. destruct C as (t & I & C).
    apply (F r t ltac:(lra) I).
    destruct (count_triangle (between q (middle t0) r) t (t_positive _ _ _ _ H t I)) as (B & In_ & _).
    apply In_. lia.
  - intros (t & I & Q) a b w L.
    assert (0 <= affine (- a) (- b) w q); [|unfold affine in *; lra].
    apply affine_in_triangle with t; [apply (t_positive _ _ _ _ H); assumption|assumption|].
    intros p C. specialize (L p (t_corners _ _ _ _ H t p I C)). unfold affine. lra.
Qed.

(* Inside a triangle there are points off a given line. *)
Lemma interior_off_line t a b c : positive t -> 0 < orient a b c -> exists z, in_interior z t /\ orient a b z <> 0.
Proof.
  intros A L. destruct (Req_dec (orient a b (middle t)) 0) as [Z|N];
    [|exists (middle t); split; [apply middle_interior|]; assumption].
  assert (C : exists v, corner v t /\ orient a b v <> 0).
  { destruct t as [[x y] z]; cbn in *.
    destruct (Req_dec (orient a b x) 0); [|exists x; auto].
    destruct (Req_dec (orient a b y) 0); [|exists y; auto].
    destruct (Req_dec (orient a b z) 0); [|exists z; auto].
    exfalso. assert (orient a b c = 0); [|lra]. rewrite orient_affine.
    apply affine_zero with x y z; rewrite <- ?orient_affine; assumption. }
  destruct C as (v & V & N). exists (between v (middle t) (1 / 2)). split.
  - apply interior_between; [assumption|apply middle_interior; assumption| |lra].
    apply corner_in_triangle; assumption.
  - rewrite orient_between, Z. lra.
Qed.

(* A point on a side, by the areas to both sides of it. *)
Lemma on_side a b c p : 0 < orient a b c -> orient a b p = 0 -> p = between a b (orient c a p / orient a b c).
Proof.
  intros A Z. pose proof (orient_sum a b c p) as S.
  pose proof (affine_mean 1 0 0 a b c p) as MX. pose proof (affine_mean 0 1 0 a b c p) as MY.
  unfold affine in MX, MY. rewrite Z in MX, MY, S.
  assert (B : orient b c p = orient a b c - orient c a p) by lra. rewrite B in MX, MY.
  unfold between. apply point_eq; cbn; apply Rmult_eq_reg_l with (orient a b c); try lra.
  - replace (orient a b c * (X a + orient c a p / orient a b c * (X b - X a)))
      with (orient a b c * X a + orient c a p * (X b - X a)) by (field; lra). lra.
  - replace (orient a b c * (Y a + orient c a p / orient a b c * (Y b - Y a)))
      with (orient a b c * Y a + orient c a p * (Y b - Y a)) by (field; lra). lra.
Qed.

Lemma at_corner a b c p : 0 < orient a b c -> orient a b p = 0 -> orient c a p = 0 -> p = a.
Proof.
  intros A Z W. rewrite (on_side a b c p A Z), W. unfold between. apply point_eq; cbn; field; lra.
Qed.

(* On the inside of a side of one triangle is on the inside of the side of the other one. *)
Lemma across a b c d p : 0 < orient a b c -> 0 < orient b a d -> orient a b p = 0 ->
  0 < orient b c p -> 0 < orient c a p -> 0 < orient a d p /\ 0 < orient d b p /\ orient b a p = 0.
Proof.
  intros A B Z V W. pose proof (orient_sum a b c p) as S.
  set (s := orient c a p / orient a b c).
  assert (Es : s * orient a b c = orient c a p) by (unfold s; field; lra).
  assert (s < 1) by nra. assert (0 < s) by nra.
  rewrite (on_side a b c p A Z). fold s. rewrite !orient_between.
  destruct (orient_same a d) as [-> _]. destruct (orient_same d b) as [_ ->].
  destruct (orient_same b a) as [-> ->]. rewrite (orient_turn b a d).
  assert (F : orient d b a = orient b a d) by (symmetry; apply orient_turn).
  rewrite F. repeat split; nra.
Qed.

Lemma on_side_corner t a b c p : In t T -> turned t a b c -> In p P -> orient a b p = 0 ->
  0 <= orient b c p -> 0 <= orient c a p -> corner p t.
Proof.
  intros I Tt Hp Z V W.
  pose proof (turned_positive _ _ _ _ Tt (t_positive _ _ _ _ H t I)) as A.
  destruct (Req_dec (orient c a p) 0) as [W0|W0].
  { apply (turned_corner _ _ _ _ _ Tt). left. apply at_corner with b c; assumption. }
  destruct (Req_dec (orient b c p) 0) as [V0|V0].
  { apply (turned_corner _ _ _ _ _ Tt). right; left. apply at_corner with c a; try assumption.
    rewrite orient_turn; assumption. }
  exfalso. assert (V' : 0 < orient b c p) by lra. assert (W' : 0 < orient c a p) by lra.
  destruct (t_all _ _ _ _ H p Hp) as (t' & I' & C').
  pose proof (t_positive _ _ _ _ H t' I') as A'.
  destruct (interior_off_line t' a b c A' A) as (z & Iz & Nz).
  pose proof (corner_in_triangle p t' A' C') as Cp.
  destruct (Rlt_dec 0 (orient a b z)) as [L|L].
  - destruct (turned_soon t a b c p z Tt) as (r & R & S); [right; auto|left; auto|left; auto|].
    specialize (S r ltac:(lra)).
    pose proof (interior_between t' p z r A' Iz Cp R) as S'.
    rewrite (tiled_unique t t' _ I I' S S') in Tt. apply (turned_corner _ _ _ _ _ Tt) in C'.
    destruct C' as [->|[->| ->]].
    + destruct (orient_same c a) as [_ K]; lra.
    + destruct (orient_same b c) as [K _]; lra.
    + lra.
  - destruct (t_sides _ _ _ _ H t a b c I Tt) as [B|(t2 & d & I2 & T2 & _)].
    + assert (0 <= orient a b z); [|lra]. rewrite orient_affine.
      apply affine_in_triangle with t'; [assumption|apply interior_closed; assumption|].
      intros x Cx. rewrite <- orient_affine. apply B. apply (t_corners _ _ _ _ H) with t'; assumption.
    + pose proof (turned_positive _ _ _ _ T2 (t_positive _ _ _ _ H t2 I2)) as A2.
      destruct (across a b c d p A A2 Z V' W') as (X1 & X2 & X3).
      destruct (turned_soon t2 b a d p z T2) as (r & R & S);
        [right; split; [assumption|rewrite orient_swap; lra]|left; auto|left; auto|].
      specialize (S r ltac:(lra)).
      pose proof (interior_between t' p z r A' Iz Cp R) as S'.
      rewrite (tiled_unique t2 t' _ I2 I' S S') in T2. apply (turned_corner _ _ _ _ _ T2) in C'.
      destruct C' as [->|[->| ->]].
      * destruct (orient_same b c) as [K _]; lra.
      * destruct (orient_same c a) as [_ K]; lra.
      * lra.
Qed.

Lemma tiled_no_point p t : In p P -> In t T -> in_triangle p t -> corner p t.
Proof.
  intros Hp I Q. destruct t as [[a b] c] eqn:Et. rewrite <- Et in *.
  assert (Ta : turned t a b c) by (left; assumption).
  pose proof (turned_next _ _ _ _ Ta) as Tb. pose proof (turned_next _ _ _ _ Tb) as Tc.
  pose proof Q as Q'. rewrite (turned_triangle _ _ _ _ _ Ta) in Q'. destruct Q' as (Q1 & Q2 & Q3).
  destruct (Req_dec (orient a b p) 0) as [Z|Z1]; [apply on_side_corner with a b c; assumption|].
  destruct (Req_dec (orient b c p) 0) as [Z|Z2]; [apply on_side_corner with b c a; assumption|].
  destruct (Req_dec (orient c a p) 0) as [Z|Z3]; [apply on_side_corner with c a b; assumption|].
  destruct (t_all _ _ _ _ H p Hp) as (t' & I' & C').
  pose proof (t_positive _ _ _ _ H t' I') as A'.
  destruct (turned_soon t a b c p (middle t') Ta) as (r & R & S); [left; lra|left; lra|left; lra|].
  specialize (S r ltac:(lra)).
  pose proof (interior_between t' p _ r A' (middle_interior _ A') (corner_in_triangle _ _ A' C') R) as S'.
  rewrite (tiled_unique t t' _ I I' S S'). assumption.
Qed.
End Cover.
