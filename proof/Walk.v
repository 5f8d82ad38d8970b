(* No point in the circle of a triangle is seen from its inside. Walk from q towards p. The walk leaves a triangle
   through the inside of a side, never through a corner: that corner would be strictly inside the circle and on it.
   Behind a side that is locally Delaunay, p is in the circle of the next triangle. So the walk ends only at an edge.
   One walk also serves the rule of the first corner. There p may be on the circle if p comes before all corners. *)
Require Import Reals ZArith List Lra Lia Psatz.
Require Import Spec Geometry Count Check Place Laid Tiling Cover.
Import ListNotations.
Open Scope R_scope.

(* Three functions on a segment, positive at its beginning: the first of them to be 0. *)
Lemma exit_point f1 f2 f3 g1 g2 g3 : 0 < f1 -> 0 < f2 -> 0 < f3 -> g1 < 0 \/ g2 < 0 \/ g3 < 0 ->
  exists s, 0 < s < 1 /\
    let v1 := (1 - s) * f1 + s * g1 in let v2 := (1 - s) * f2 + s * g2 in let v3 := (1 - s) * f3 + s * g3 in
    0 <= v1 /\ 0 <= v2 /\ 0 <= v3 /\ ((v1 = 0 /\ g1 < 0) \/ (v2 = 0 /\ g2 < 0) \/ (v3 = 0 /\ g3 < 0)).
Proof.
  intros F1 F2 F3 G.
  assert (Z : forall f g, 0 < f -> exists r, 0 < r /\ (forall s, 0 < s <= r -> s < 1 -> 0 <= (1 - s) * f + s * g) /\
      ((g < 0 /\ r < 1 /\ (1 - r) * f + r * g = 0) \/ (0 <= g /\ r = 1))).
  { intros f g F. destruct (Rlt_dec g 0) as [L|L].
    - exists (f / (f - g)). assert (D : f / (f - g) * (f - g) = f) by (field; lra).
      assert (0 < f / (f - g)) by (apply Rdiv_lt_0_compat; lra).
      split; [assumption|]. split.
      + intros s S _. assert (s * (f - g) <= f) by (rewrite <- D at 2; apply Rmult_le_compat_r; lra). lra.
      + left. split; [assumption|]. split; [|lra]. apply Rmult_lt_reg_r with (f - g); lra.
    - exists 1. split; [lra|]. split; [|right; lra].
      intros s S S'. assert (0 <= (1 - s) * f) by (apply Rmult_le_pos; lra).
      assert (0 <= s * g) by (apply Rmult_le_pos; lra). lra. }
  destruct (Z f1 g1 F1) as (r1 & R1 & V1 & W1). destruct (Z f2 g2 F2) as (r2 & R2 & V2 & W2).
  destruct (Z f3 g3 F3) as (r3 & R3 & V3 & W3). clear Z.
  destruct (Rle_dec r1 r2) as [A|A], (Rle_dec r1 r3) as [B|B], (Rle_dec r2 r3) as [C|C]; try lra;
  first [ assert (K : r1 <= r2 /\ r1 <= r3) by lra; exists r1
        | assert (K : r2 <= r1 /\ r2 <= r3) by lra; exists r2
        | assert (K : r3 <= r1 /\ r3 <= r2) by lra; exists r3 ];
  cbn zeta; (split; [lra|]);
  (split; [apply V1; lra|split; [apply V2; lra|split; [apply V3; lra|]]]);
  destruct W1 as [W1|W1], W2 as [W2|W2], W3 as [W3|W3]; lra.
Qed.

Lemma cross_longer a b q p s : 0 < s < 1 -> cross a b (between q p s) p -> cross a b q p.
Proof.
  unfold cross. intros S [A B].
  assert (E : forall x, orient (between q p s) p x = (1 - s) * orient q p x) by (intros; flat; ring).
  rewrite !E in B. rewrite orient_between in A. split.
  - assert (0 <= s * (orient a b p * orient a b p)).
    { apply Rmult_le_pos; [lra|]. pose proof (Rle_0_sqr (orient a b p)). unfold Rsqr in *; lra. }
    assert ((1 - s) * (orient a b q * orient a b p) < 0) by lra.
    apply Rmult_lt_reg_l with (1 - s); lra.
  - apply Rmult_lt_reg_l with ((1 - s) * (1 - s)); [apply Rmult_lt_0_compat; lra|]. lra.
Qed.

Lemma sign_of_product x y k : 0 < k * x -> k * y < 0 -> x * y < 0.
Proof.
  intros A B. assert (0 < k * k) by (destruct (Rtotal_order k 0) as [|[->|]]; nra).
  assert ((k * x) * (k * y) < 0) by nra. assert ((k * k) * (x * y) < 0) by lra.
  apply Rmult_lt_reg_l with (k * k); lra.
Qed.

(* An edge along a side that the segment passes. *)
Lemma edge_crosses e f a b m p s : on_segment a e f -> on_segment b e f ->
  0 < orient a b m -> orient a b p < 0 -> 0 < s < 1 ->
  forall r, 0 < r < 1 -> between m p s = between a b r -> cross e f m p.
Proof.
  intros [al [Al Ea]] [be [Be Eb]] M N S r R X. split.
  - assert (D : forall v, orient a b v = (be - al) * orient e f v) by (intros v; subst a b; flat; ring).
    rewrite D in M, N. apply sign_of_product with (be - al); assumption.
  - assert (Z : (1 - r) * orient m p a + r * orient m p b = 0).
    { rewrite <- orient_between, <- X, orient_between. destruct (orient_same m p) as [-> ->]. ring. }
    assert (D : orient m p b - orient m p a = orient a b m - orient a b p) by (flat; ring).
    assert (A : orient m p a < 0).
    { assert (orient m p a = - r * (orient m p b - orient m p a)) by lra. rewrite H.
      assert (0 < r * (orient m p b - orient m p a)) by (apply Rmult_lt_0_compat; lra). lra. }
    assert (B : 0 < orient m p b).
    { assert (orient m p b = (1 - r) * (orient m p b - orient m p a)) by lra. rewrite H.
      apply Rmult_lt_0_compat; lra. }
    rewrite Ea in A. rewrite Eb in B. rewrite orient_between in A, B.
    set (x := orient m p e) in *. set (y := orient m p f) in *.
    destruct (Rle_dec 0 x) as [Hx|Hx], (Rle_dec 0 y) as [Hy|Hy].
    + assert (0 <= (1 - al) * x) by (apply Rmult_le_pos; lra). assert (0 <= al * y) by (apply Rmult_le_pos; lra). lra.
    + destruct (Req_dec x 0) as [X0|X0]; [|nra].
      rewrite X0 in B. assert (be * y <= 0) by nra. lra.
    + destruct (Req_dec y 0) as [Y0|Y0]; [|nra].
      rewrite Y0 in B. assert ((1 - be) * x <= 0) by nra. lra.
    + assert ((1 - be) * x <= 0) by nra. assert (be * y <= 0) by nra. lra.
Qed.

Section Walk.
Variables (rule : bool) (P : list point) (E : list edge) (T : list triangle).
Hypothesis H : tiled rule P E T.

(* p is in the circle of t, or on it and before all corners. *)
Definition inside_or_first (p : point) (t : triangle) : Prop :=
  in_circle p t \/ (rule = true /\ on_circle p t /\ forall x, corner x t -> first p x).

Lemma inside_no_corner p t : positive t -> inside_or_first p t -> ~ corner p t /\ (in_circle p t \/ on_circle p t).
Proof.
  intros A C. destruct (turned_centre_exists t A) as [o O]. split; [|destruct C as [|(_ & ? & _)]; auto].
  intros K. destruct (turned_exists t p K) as (b & c & Tt). destruct C as [C|(_ & _ & F)].
  - apply (in_circle_power t p b c o p A Tt O) in C. unfold power in C. lra.
  - specialize (F p K). unfold first in F. lra.
Qed.

(* The walk leaves t through the inside of a side. *)
Lemma leave t m p : In t T -> In p P -> in_interior m t -> ~ corner p t -> in_circle p t \/ on_circle p t ->
  exists a b c s r, turned t a b c /\ 0 < s < 1 /\ 0 < r < 1 /\ between m p s = between a b r /\
    orient a b p < 0 /\ orient a b (between m p s) = 0 /\
    0 < orient b c (between m p s) /\ 0 < orient c a (between m p s).
Proof.
  intros I Hp M NC C. pose proof (t_positive _ _ _ _ H t I) as A.
  destruct (turned_centre_exists t A) as [o O].
  assert (G : forall a b c s, turned t a b c -> 0 < s < 1 -> orient a b p < 0 -> orient a b (between m p s) = 0 ->
    0 <= orient b c (between m p s) -> 0 <= orient c a (between m p s) ->
    exists a b c s r, turned t a b c /\ 0 < s < 1 /\ 0 < r < 1 /\ between m p s = between a b r /\
    orient a b p < 0 /\ orient a b (between m p s) = 0 /\
    0 < orient b c (between m p s) /\ 0 < orient c a (between m p s)).
  { intros a b c s Tt S N Z V W.
    pose proof (turned_positive _ _ _ _ Tt A) as A'.
    pose proof (interior_in_circle t a b c o m Tt O M) as Cm.
    assert (Cp : power o a p <= 0).
    { destruct C as [C|C].
      - apply (in_circle_power t a b c o p A Tt O) in C. lra.
      - apply (on_circle_power t a b c o p A Tt O) in C. lra. }
    assert (Cx : power o a (between m p s) < 0).
    { rewrite power_between. pose proof (dist2_nonneg m p).
      assert ((1 - s) * power o a m < 0) by nra. assert (s * power o a p <= 0) by nra.
      assert (0 <= s * (1 - s) * dist2 m p) by (apply Rmult_le_pos; [nra|assumption]). lra. }
    pose proof O as O'. apply (turned_centre _ _ _ _ _ Tt) in O'. destruct O' as [O1 O2].
    assert (W' : 0 < orient c a (between m p s)).
    { destruct (Req_dec (orient c a (between m p s)) 0) as [W0|]; [exfalso|lra].
      rewrite (at_corner a b c _ A' Z W0) in Cx. unfold power in Cx. lra. }
    assert (V' : 0 < orient b c (between m p s)).
    { destruct (Req_dec (orient b c (between m p s)) 0) as [V0|]; [exfalso|lra].
      assert (A2 : 0 < orient b c a) by (rewrite orient_turn; assumption).
      rewrite (at_corner b c a _ A2 V0 Z) in Cx. unfold power in Cx. lra. }
    pose proof (orient_sum a b c (between m p s)) as Sum.
    set (r := orient c a (between m p s) / orient a b c).
    assert (Er : r * orient a b c = orient c a (between m p s)) by (unfold r; field; lra).
    exists a, b, c, s, r. repeat split; try assumption; try lra; try nra.
    apply on_side; assumption. }
  assert (NT : ~ in_triangle p t) by (intros K; apply NC; apply (tiled_no_point _ _ _ _ H); assumption).
  destruct t as [[a b] c] eqn:Et. rewrite <- Et in *.
  assert (Ta : turned t a b c) by (left; assumption).
  pose proof (turned_next _ _ _ _ Ta) as Tb. pose proof (turned_next _ _ _ _ Tb) as Tc.
  pose proof M as M'. apply (turned_interior _ _ _ _ _ Ta) in M'. destruct M' as (M1 & M2 & M3).
  rewrite (turned_triangle _ _ _ _ _ Ta) in NT.
  destruct (exit_point _ _ _ (orient a b p) (orient b c p) (orient c a p) M1 M2 M3) as (s & S & X).
  { destruct (Rlt_dec (orient a b p) 0); [auto|]. destruct (Rlt_dec (orient b c p) 0); [auto|].
    destruct (Rlt_dec (orient c a p) 0); [auto|]. exfalso. apply NT. lra. }
  cbn zeta in X. rewrite <- !orient_between in X. destruct X as (X1 & X2 & X3 & [[Z N]|[[Z N]|[Z N]]]).
  - apply (G a b c s); assumption.
  - apply (G b c a s); assumption.
  - apply (G c a b s); assumption.
Qed.

(* The circle of the next triangle. *)
Lemma next_circle t v a b c d p : In t T -> In v T -> turned t a b c -> turned v b a d -> orient a b p < 0 ->
  circle a b c d <= 0 ->
  (in_circle p t -> in_circle p v) /\
  (on_circle p t -> circle a b c d < 0 -> in_circle p v) /\
  (on_circle p t -> circle a b c d = 0 -> on_circle p v /\ on_circle d t).
Proof.
  intros I J Tt Tv N L. pose proof (t_positive _ _ _ _ H t I) as A. pose proof (t_positive _ _ _ _ H v J) as B.
  pose proof (turned_positive _ _ _ _ Tt A) as A'. pose proof (turned_positive _ _ _ _ Tv B) as B'.
  destruct (turned_centre_exists t A) as [o O]. destruct (turned_centre_exists v B) as [w W].
  rewrite (in_circle_power t a b c o p A Tt O), (in_circle_power v b a d w p B Tv W).
  rewrite (on_circle_power t a b c o p A Tt O), (on_circle_power v b a d w p B Tv W).
  rewrite (on_circle_power t a b c o d A Tt O).
  apply (turned_centre _ _ _ _ _ Tt) in O. apply (turned_centre _ _ _ _ _ Tv) in W.
  destruct O as [O1 O2], W as [W1 W2].
  destruct (circle_power_sign o a b c d O1 O2 A') as (K1 & K2 & K3).
  pose proof (power_difference o a w b) as D.
  set (k1 := 2 * (X w - X o)) in D. set (k2 := 2 * (Y w - Y o)) in D. set (k3 := _ + _ + _ - _ - _) in D.
  assert (Da : affine k1 k2 k3 a = 0) by (rewrite <- D; unfold power; lra).
  assert (Db : affine k1 k2 k3 b = 0) by (rewrite <- D; unfold power; lra).
  assert (Dd : affine k1 k2 k3 d = power o a d).
  { rewrite <- D. assert (power w b d = 0) by (unfold power; lra). lra. }
  pose proof (affine_side k1 k2 k3 a b d p Da Db) as F. rewrite Dd, <- D in F.
  rewrite orient_swap in B'.
  assert (0 <= power o a d) by (apply K3; assumption).
  set (x := orient a b d) in *. set (y := orient a b p) in *. set (h := power o a d) in *.
  assert (Q : 0 <= power o a p - power w b p).
  { assert (y * h <= 0) by nra. assert (x * (power o a p - power w b p) <= 0) by lra. nra. }
  split; [intros; lra|split].
  - intros P0 L0. assert (0 < h) by (destruct (Req_dec h 0) as [h0|]; [apply K2 in h0; lra|lra]).
    assert (y * h < 0) by nra. assert (x * (power o a p - power w b p) < 0) by lra. nra.
  - intros P0 L0. apply K2 in L0. split; [|assumption]. rewrite L0 in F.
    assert (Z : x * (power o a p - power w b p) = 0) by lra. apply Rmult_integral in Z. lra.
Qed.

Lemma next_inside t v a b c d p : In t T -> In v T -> turned t a b c -> turned v b a d -> orient a b p < 0 ->
  circle a b c d <= 0 -> (rule = true -> circle a b c d = 0 -> tie_kept a b c d) ->
  inside_or_first p t -> inside_or_first p v.
Proof.
  intros I J Tt Tv N L R [C|(Y & C & F)].
  - left. exact (proj1 (next_circle t v a b c d p I J Tt Tv N L) C).
  - destruct (next_circle t v a b c d p I J Tt Tv N L) as (_ & K1 & K2).
    destruct (Rlt_dec (circle a b c d) 0) as [S|S]; [left; auto|].
    assert (Z : circle a b c d = 0) by lra. destruct (K2 C Z) as [K _]. right. split; [assumption|].
    split; [assumption|].
    assert (Fa : first p a) by (apply F; apply (turned_corner _ _ _ _ _ Tt); auto).
    assert (Fb : first p b) by (apply F; apply (turned_corner _ _ _ _ _ Tt); auto).
    pose proof (turned_positive _ _ _ _ Tv (t_positive _ _ _ _ H v J)) as B.
    intros x Cx. apply (turned_corner _ _ _ _ _ Tv) in Cx. destruct Cx as [->|[->| ->]]; try assumption.
    destruct (R Y Z) as [D|D]; specialize (D d ltac:(cbn; auto)); destruct D as [->|D].
    + destruct (orient_same b d) as [_ K0]. lra.
    + apply first_transitive with a; assumption.
    + destruct (orient_same d a) as [K0 _]. lra.
    + apply first_transitive with b; assumption.
Qed.

Lemma between_later m p s r : between (between m p s) p r = between m p (s + r - r * s).
Proof. symmetry; apply between_between. Qed.

(* Beyond the side the walk is in the next triangle. *)
Lemma enter t v a b c d m p s : In t T -> In v T -> turned t a b c -> turned v b a d -> 0 < s < 1 -> orient a b p < 0 ->
  orient a b (between m p s) = 0 -> 0 < orient b c (between m p s) -> 0 < orient c a (between m p s) ->
  exists s2, s < s2 < 1 /\ in_interior (between m p s2) v.
Proof.
  intros I J Tt Tv S N Z V W.
  pose proof (turned_positive _ _ _ _ Tt (t_positive _ _ _ _ H t I)) as A.
  pose proof (turned_positive _ _ _ _ Tv (t_positive _ _ _ _ H v J)) as A2.
  destruct (across a b c d _ A A2 Z V W) as (X1 & X2 & X3).
  destruct (turned_soon v b a d (between m p s) p Tv) as (k & K & Sn);
    [right; split; [assumption|rewrite orient_swap; lra]|left; auto|left; auto|].
  set (h := Rmin k (1 / 2)).
  pose proof (Rmin_l k (1 / 2)) as Hk. pose proof (Rmin_r k (1 / 2)) as Hh. fold h in Hk, Hh.
  assert (h0 : 0 < h) by (unfold h; apply Rmin_glb_lt; lra).
  specialize (Sn h ltac:(lra)). rewrite between_later in Sn.
  exists (s + h - h * s). split; [split; nra|assumption].
Qed.

Lemma walk : forall (n : nat) (L : list triangle) t m p, (length L <= n)%nat -> In t T -> In p P ->
  in_interior m t -> inside_or_first p t ->
  (forall v r, In v T -> 0 <= r <= 1 -> in_interior (between m p r) v -> In v L) -> blocked E m p.
Proof.
  induction n as [|n IH]; intros L t m p Len I Hp M C All.
  { assert (In t L).
    { apply (All t 0); [assumption|lra|]. replace (between m p 0) with m; [assumption|].
      unfold between; apply point_eq; cbn; ring. }
    destruct L; [contradiction|cbn in Len; lia]. }
  destruct (inside_no_corner p t (t_positive _ _ _ _ H t I) C) as [NC C0].
  destruct (leave t m p I Hp M NC C0) as (a & b & c & s & r & Tt & S & R & X & N & Z & V & W).
  pose proof M as M'. apply (turned_interior _ _ _ _ _ Tt) in M'. destruct M' as (M1 & _ & _).
  destruct (t_sides _ _ _ _ H t a b c I Tt) as [B|(v & d & J & Tv & F)].
  { specialize (B p Hp). lra. }
  destruct F as [(e & f & Ief & Sa & Sb)|[L1 L2]].
  { exists e, f. split; [assumption|]. apply (edge_crosses e f a b m p s) with r; assumption. }
  assert (C' : inside_or_first p v) by (apply (next_inside t v a b c d p); assumption).
  destruct (enter t v a b c d m p s) as (s2 & S2 & Sn); try assumption.
  assert (It : In t L).
  { apply (All t 0); [assumption|lra|]. replace (between m p 0) with m; [assumption|].
    unfold between; apply point_eq; cbn; ring. }
  apply in_split in It. destruct It as (l1 & l2 & ->).
  destruct (IH (l1 ++ l2) v (between m p s2) p) as (e & f & Ief & Cr); try assumption.
  - rewrite app_length in *. cbn in Len. lia.
  - intros w q Iw Q Jw. rewrite between_later in Jw.
    assert (Q2 : s < s2 + q - q * s2 <= 1) by (split; nra).
    assert (Iw' : In w (l1 ++ t :: l2)) by (apply (All w (s2 + q - q * s2)); [assumption|lra|assumption]).
    apply in_app_or in Iw'. apply in_or_app. destruct Iw' as [|[->|]]; auto. exfalso.
    apply (turned_interior _ _ _ _ _ Tt) in Jw. destruct Jw as (J1 & _ & _).
    rewrite orient_between in J1, Z. nra.
  - exists e, f. split; [assumption|]. apply cross_longer with s2; [lra|assumption].
Qed.

Lemma tiled_delaunay t p q : In t T -> In p P -> in_circle p t -> in_interior q t -> blocked E q p.
Proof.
  intros I Hp C Q. apply (walk (length T) T t q p); try assumption; auto. left; assumption.
Qed.

Lemma tiled_triangulation : triangulation P E T.
Proof.
  split.
  - intros a b c I. exact (t_positive _ _ _ _ H _ I).
  - apply (t_corners _ _ _ _ H).
  - apply (tiled_no_overlap _ _ _ _ H).
  - apply (tiled_hull _ _ _ _ H).
  - apply (t_all _ _ _ _ H).
  - intros p t. apply (tiled_no_point _ _ _ _ H).
  - apply (t_edges _ _ _ _ H).
  - apply tiled_delaunay.
Qed.

(* A point on the circle lies beyond one side only. *)
Lemma one_arc a b c p : 0 < orient a b c -> circle a b c p = 0 -> orient a b p < 0 -> orient b c p < 0 -> False.
Proof.
  intros A Z N M.
  assert (F : circle a b c p = orient b c p * dist2 a b + orient a b p * dist2 c b - orient a b c * dist2 p b)
    by (unfold circle; flat; ring).
  pose proof (dist2_nonneg c b). pose proof (dist2_nonneg p b). pose proof (dist2_nonneg a b).
  assert (0 < dist2 a b).
  { destruct (Req_dec (dist2 a b) 0) as [K|]; [|lra]. apply dist2_zero in K. subst b.
    assert (orient a a c = 0) by (flat; ring). lra. }
  assert (orient b c p * dist2 a b < 0) by nra. assert (orient a b p * dist2 c b <= 0) by nra.
  assert (0 <= orient a b c * dist2 p b) by nra. lra.
Qed.

Lemma first_asymmetric a b : first a b -> first b a -> False.
Proof. unfold first. lra. Qed.

(* The first of four points. *)
Lemma first_of_four a b c p : first_of a [a; b; c; p] \/ first_of b [a; b; c; p] \/
  (first c a /\ first c b) \/ (first p a /\ first p b /\ first p c).
Proof.
  unfold first_of.
  assert (G : forall x, (x = a \/ first x a) -> (x = b \/ first x b) -> (x = c \/ first x c) -> (x = p \/ first x p) ->
    forall y, In y [a; b; c; p] -> x = y \/ first x y).
  { intros x Ha Hb Hc Hp y [<-|[<-|[<-|[<-|[]]]]]; assumption. }
  assert (W : forall x y, (x = y \/ first x y) \/ first y x)
    by (intros x y; destruct (first_total x y) as [|[|]]; auto).
  assert (L : forall x y z, first x y -> y = z \/ first y z -> first x z)
    by (intros x y z A [<-|B]; [assumption|apply first_transitive with y; assumption]).
  destruct (W a b) as [Ab|Ba].
  - destruct (W a c) as [Ac|Ca].
    + destruct (W a p) as [Ap|Pa]; [left; apply G; auto|]. do 3 right. repeat split; eauto.
    + destruct (W c p) as [Cp|Pc]; [right; right; left; eauto|]. do 3 right. repeat split; eauto.
  - destruct (W b c) as [Bc|Cb].
    + destruct (W b p) as [Bp|Pb]; [right; left; apply G; auto|]. do 3 right. repeat split; eauto.
    + destruct (W c p) as [Cp|Pc]; [right; right; left; eauto|]. do 3 right. repeat split; eauto.
Qed.

(* The rule: where no edge blocks the view, an end of the side is the first corner. *)
Lemma tiled_first_corner : rule = true -> first_corner_rule P E T.
Proof.
  intros Y t a b c p q I Sd Cc Na Nb Hp C N Q.
  assert (Tt : turned t a b c).
  { apply side_turned in Sd. destruct Sd as [x Tx]. apply (turned_corner _ _ _ _ _ Tx) in Cc.
    destruct Cc as [|[|]]; [congruence|congruence|subst; assumption]. }
  pose proof (t_positive _ _ _ _ H t I) as A. pose proof (turned_positive _ _ _ _ Tt A) as A'.
  destruct (first_of_four a b c p) as [F|[F|[[F1 F2]|(F1 & F2 & F3)]]]; [auto|auto| |]; left.
  - assert (NC : ~ corner p t).
    { intros K. apply (turned_corner _ _ _ _ _ Tt) in K. destruct (orient_same a b) as [K1 K2].
      destruct K as [->|[->| ->]]; lra. }
    destruct (turned_centre_exists t A) as [o O].
    assert (Z0 : circle a b c p = 0).
    { pose proof C as C'. apply (on_circle_power t a b c o p A Tt O) in C'.
      apply (turned_centre _ _ _ _ _ Tt) in O. apply (circle_power_sign o a b c p); tauto. }
    destruct (leave t q p I Hp Q NC (or_intror C)) as (a' & b' & c' & s & r & Tt' & S & R & X & N' & Z & V & W).
    destruct (turned_three _ _ _ _ _ _ _ Tt Tt') as [(->&->&->)|[(->&->&->)|(->&->&->)]].
    2: { exfalso. apply (one_arc a b c p); assumption. }
    2: { exfalso. apply (one_arc c a b p); try assumption.
         - rewrite <- orient_turn; assumption.
         - rewrite <- Z0. unfold circle; flat; ring. }
    pose proof Q as Q'. apply (turned_interior _ _ _ _ _ Tt) in Q'. destruct Q' as (Q1 & _ & _).
    destruct (t_sides _ _ _ _ H t a b c I Tt) as [B|(v & d & J & Tv & F)].
    { specialize (B p Hp). lra. }
    destruct F as [(e & f & Ief & Sa & Sb)|[L1 L2]].
    { exists e, f. split; [assumption|]. apply (edge_crosses e f a b q p s) with r; assumption. }
    destruct (Rlt_dec (circle a b c d) 0) as [L|L].
    + destruct (next_circle t v a b c d p I J Tt Tv N L1) as (_ & K & _).
      destruct (enter t v a b c d q p s) as (s2 & S2 & Sn); try assumption.
      destruct (walk (length T) T v (between q p s2) p) as (e & f & Ief & Cr); auto. { left; auto. }
      exists e, f. split; [assumption|]. apply cross_longer with s2; [lra|assumption].
    + exfalso. assert (Z1 : circle a b c d = 0) by lra.
      destruct (L2 Y Z1) as [D|D]; specialize (D c ltac:(cbn; auto)); destruct D as [D|D]; try congruence;
      eauto using first_asymmetric.
  - apply (walk (length T) T t q p); auto. right. split; [assumption|]. split; [assumption|].
    intros x Cx. apply (turned_corner _ _ _ _ _ Tt) in Cx. destruct Cx as [->|[->| ->]]; assumption.
Qed.
End Walk.
