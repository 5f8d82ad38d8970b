(* Plane geometry by identities of polynomials: affine functions on a triangle, segments, circles by their centres. *)
Require Import Reals List Lra Psatz.
Require Import Spec.
Import ListNotations.
Open Scope R_scope.

Ltac flat := repeat match goal with p : point |- _ => destruct p end;
  unfold orient, dist2, between in *; cbn [X Y] in *.

Lemma orient_turn a b c : orient b c a = orient a b c.
Proof. flat; ring. Qed.

Lemma orient_swap a b c : orient b a c = - orient a b c.
Proof. flat; ring. Qed.

Lemma orient_sum a b c q : orient a b q + orient b c q + orient c a q = orient a b c.
Proof. flat; ring. Qed.

Lemma orient_same a b : orient a b a = 0 /\ orient a b b = 0.
Proof. flat; split; ring. Qed.

Lemma orient_between a b p q s : orient a b (between p q s) = (1 - s) * orient a b p + s * orient a b q.
Proof. flat; ring. Qed.

Lemma point_eq p q : X p = X q -> Y p = Y q -> p = q.
Proof. destruct p, q; cbn; intros; subst; reflexivity. Qed.

(* An affine function on a triangle is the mean of its values at the corners. *)
Definition affine (u v w : R) (p : point) : R := u * X p + v * Y p + w.

Lemma affine_mean u v w a b c q : orient a b c * affine u v w q
  = orient b c q * affine u v w a + orient c a q * affine u v w b + orient a b q * affine u v w c.
Proof. unfold affine; flat; ring. Qed.

Lemma affine_between u v w p q s :
  affine u v w (between p q s) = (1 - s) * affine u v w p + s * affine u v w q.
Proof. unfold affine; flat; ring. Qed.

Lemma orient_affine a b q : orient a b q
  = affine (- (Y b - Y a)) (X b - X a) ((Y b - Y a) * X a - (X b - X a) * Y a) q.
Proof. unfold affine; flat; ring. Qed.

(* The triangle t, begun at another corner. *)
Definition turned (t : triangle) (a b c : point) : Prop := t = (a, b, c) \/ t = (b, c, a) \/ t = (c, a, b).

Lemma turned_next t a b c : turned t a b c -> turned t b c a.
Proof. unfold turned; intuition. Qed.

Lemma side_turned t a b : side a b t <-> exists c, turned t a b c.
Proof.
  destruct t as [[x y] z]; unfold side, turned; cbn; split.
  - intros [H | [H | H]]; inversion H; subst; [exists z | exists x | exists y]; auto.
  - intros [c [H | [H | H]]]; inversion H; subst; auto.
Qed.

Lemma turned_corner t a b c p : turned t a b c -> (corner p t <-> p = a \/ p = b \/ p = c).
Proof. intros [H | [H | H]]; subst; cbn; intuition. Qed.

Lemma turned_interior t a b c q : turned t a b c ->
  (in_interior q t <-> 0 < orient a b q /\ 0 < orient b c q /\ 0 < orient c a q).
Proof. intros [H | [H | H]]; subst; cbn; intuition. Qed.

Lemma turned_triangle t a b c q : turned t a b c ->
  (in_triangle q t <-> 0 <= orient a b q /\ 0 <= orient b c q /\ 0 <= orient c a q).
Proof. intros [H | [H | H]]; subst; cbn; intuition. Qed.

Lemma turned_centre t a b c o : turned t a b c -> (centre o t <-> dist2 o a = dist2 o b /\ dist2 o b = dist2 o c).
Proof. intros [H | [H | H]]; subst; cbn; intuition congruence. Qed.

Lemma turned_exists t p : corner p t -> exists b c, turned t p b c.
Proof.
  destruct t as [[x y] z]; cbn; intros [H | [H | H]]; subst; unfold turned;
  [exists y, z | exists z, x | exists x, y]; auto.
Qed.

Definition positive (t : triangle) : Prop := let '(a, b, c) := t in 0 < orient a b c.

Lemma turned_positive t a b c : turned t a b c -> positive t -> 0 < orient a b c.
Proof. intros [H | [H | H]]; subst; cbn; flat; lra. Qed.

Lemma interior_closed q t : in_interior q t -> in_triangle q t.
Proof. destruct t as [[a b] c]; cbn; lra. Qed.

Lemma interior_positive q t : in_interior q t -> positive t.
Proof. destruct t as [[a b] c]; cbn; intros; pose proof (orient_sum a b c q); lra. Qed.

(* Means of corners, of which each has some weight. *)
Lemma mean_nonneg A x y z f g h v : 0 < A -> A * v = x * f + y * g + z * h ->
  0 <= x -> 0 <= y -> 0 <= z -> 0 <= f -> 0 <= g -> 0 <= h -> 0 <= v.
Proof. intros; assert (0 <= A * v) by nra; nra. Qed.

Lemma mean_positive A x y z f g h v : 0 < A -> A * v = x * f + y * g + z * h ->
  0 < x -> 0 < y -> 0 < z -> 0 <= f -> 0 <= g -> 0 <= h -> 0 < f + g + h -> 0 < v.
Proof.
  intros HA E Hx Hy Hz Hf Hg Hh S.
  assert (0 < A * v).
  { rewrite E. assert (0 <= x * f) by nra. assert (0 <= y * g) by nra. assert (0 <= z * h) by nra.
    destruct (Rtotal_order f 0) as [|[|]]; [lra | | assert (0 < x * f) by nra; lra].
    destruct (Rtotal_order g 0) as [|[|]]; [lra | | assert (0 < y * g) by nra; lra].
    assert (0 < h) by lra. assert (0 < z * h) by nra. lra. }
  nra.
Qed.

Lemma affine_in_triangle u v w t q : positive t -> in_triangle q t ->
  (forall p, corner p t -> 0 <= affine u v w p) -> 0 <= affine u v w q.
Proof.
  destruct t as [[a b] c]; cbn; intros A (H1 & H2 & H3) H.
  pose proof (H a ltac:(auto)); pose proof (H b ltac:(auto)); pose proof (H c ltac:(auto)).
  refine (mean_nonneg _ _ _ _ _ _ _ _ A (affine_mean u v w a b c q) _ _ _ _ _ _); assumption.
Qed.

Lemma affine_in_interior u v w t q : in_interior q t ->
  (forall p, corner p t -> 0 <= affine u v w p) -> (exists p, corner p t /\ 0 < affine u v w p) ->
  0 < affine u v w q.
Proof.
  intros I. pose proof (interior_positive _ _ I) as A.
  destruct t as [[a b] c]; cbn in *; intros H [p [C S]]. destruct I as (H1 & H2 & H3).
  pose proof (H a ltac:(auto)); pose proof (H b ltac:(auto)); pose proof (H c ltac:(auto)).
  refine (mean_positive _ _ _ _ _ _ _ _ A (affine_mean u v w a b c q) _ _ _ _ _ _ _); try assumption.
  destruct C as [|[|]]; subst; lra.
Qed.

(* An affine function that is 0 at three corners, or on one side and beyond. *)
Lemma affine_zero u v w a b c q : 0 < orient a b c -> affine u v w a = 0 -> affine u v w b = 0 -> affine u v w c = 0 ->
  affine u v w q = 0.
Proof. intros A Ha Hb Hc. pose proof (affine_mean u v w a b c q) as E. rewrite Ha, Hb, Hc in E. nra. Qed.

Lemma affine_side u v w a b c q : affine u v w a = 0 -> affine u v w b = 0 ->
  orient a b c * affine u v w q = orient a b q * affine u v w c.
Proof. intros Ha Hb. pose proof (affine_mean u v w a b c q) as E. rewrite Ha, Hb in E. lra. Qed.

(* Points between. *)
Lemma interior_between t p q s : positive t -> in_interior q t -> in_triangle p t -> 0 < s <= 1 ->
  in_interior (between p q s) t.
Proof.
  destruct t as [[a b] c]; cbn; rewrite !orient_between; intros _ (? & ? & ?) (? & ? & ?) ?.
  repeat split; nra.
Qed.

Lemma corner_in_triangle p t : positive t -> corner p t -> in_triangle p t.
Proof.
  destruct t as [[a b] c]; cbn; intros A [|[|]]; subst;
    repeat split; flat; nra.
Qed.

Definition middle '((a, b, c) : triangle) : point := Point ((X a + X b + X c) / 3) ((Y a + Y b + Y c) / 3).

Lemma middle_interior t : positive t -> in_interior (middle t) t.
Proof. destruct t as [[a b] c]; cbn; intros; repeat split; flat; nra. Qed.

Lemma between_between p q s r : between p q (s + r - r * s) = between (between p q s) q r.
Proof. unfold between; cbn; f_equal; ring. Qed.

(* The power of q in the circle round o through a. *)
Definition power (o a q : point) : R := dist2 o q - dist2 o a.

Lemma power_difference o a o' a' q : power o a q - power o' a' q
  = affine (2 * (X o' - X o)) (2 * (Y o' - Y o))
      (dist2 o o - dist2 o a - dist2 o' o' + dist2 o' a' + X o * X o + Y o * Y o - X o' * X o' - Y o' * Y o') q.
Proof. unfold power, affine; flat; ring. Qed.

Lemma power_between o a p q s :
  power o a (between p q s) = (1 - s) * power o a p + s * power o a q - s * (1 - s) * dist2 p q.
Proof. unfold power; flat; ring. Qed.

Lemma dist2_nonneg p q : 0 <= dist2 p q.
Proof. unfold dist2. pose proof (Rle_0_sqr (X q - X p)); pose proof (Rle_0_sqr (Y q - Y p)). unfold Rsqr in *. lra. Qed.

Lemma dist2_zero p q : dist2 p q = 0 -> q = p.
Proof.
  unfold dist2. intros H. apply point_eq.
  - pose proof (Rplus_sqr_eq_0_l (X q - X p) (Y q - Y p) H). lra.
  - rewrite Rplus_comm in H. pose proof (Rplus_sqr_eq_0_l (Y q - Y p) (X q - X p) H). lra.
Qed.

Lemma centre_exists a b c : 0 < orient a b c -> exists o, dist2 o a = dist2 o b /\ dist2 o b = dist2 o c.
Proof.
  intros A.
  set (D := 2 * orient a b c).
  set (bx := X b - X a). set (by_ := Y b - Y a). set (cx := X c - X a). set (cy := Y c - Y a).
  exists (Point (X a + (cy * (bx * bx + by_ * by_) - by_ * (cx * cx + cy * cy)) / D)
                (Y a + (bx * (cx * cx + cy * cy) - cx * (bx * bx + by_ * by_)) / D)).
  unfold D, bx, by_, cx, cy, dist2. unfold orient in *. cbn.
  split; field; lra.
Qed.

(* The determinant: positive for p strictly inside the circle through a, b, c, which turn left. *)
Definition circle (a b c p : point) : R :=
  let ax := X a - X p in let ay := Y a - Y p in
  let bx := X b - X p in let by_ := Y b - Y p in
  let cx := X c - X p in let cy := Y c - Y p in
  (ax * ax + ay * ay) * (bx * cy - by_ * cx)
  + (bx * bx + by_ * by_) * (cx * ay - cy * ax)
  + (cx * cx + cy * cy) * (ax * by_ - ay * bx).

Lemma circle_power o a b c p : dist2 o a = dist2 o b -> dist2 o b = dist2 o c ->
  circle a b c p = - (orient a b c * power o a p).
Proof.
  intros E F.
  assert (H : circle a b c p = (dist2 o a - dist2 o p) * orient b c p
     + (dist2 o b - dist2 o p) * orient c a p + (dist2 o c - dist2 o p) * orient a b p)
    by (unfold circle; flat; ring).
  rewrite H, <- F, <- E, <- (orient_sum a b c p). unfold power. ring.
Qed.

Lemma circle_power_sign o a b c p : dist2 o a = dist2 o b -> dist2 o b = dist2 o c -> 0 < orient a b c ->
  (0 < circle a b c p <-> power o a p < 0) /\ (circle a b c p = 0 <-> power o a p = 0)
  /\ (circle a b c p <= 0 <-> 0 <= power o a p).
Proof.
  intros E F A. rewrite (circle_power o) by assumption.
  repeat split; intros; nra.
Qed.

(* Inside is inside for every centre, and the centre is one. *)
Lemma centre_unique o o' a b c : 0 < orient a b c ->
  dist2 o a = dist2 o b -> dist2 o b = dist2 o c -> dist2 o' a = dist2 o' b -> dist2 o' b = dist2 o' c ->
  forall q, power o a q = power o' a q.
Proof.
  intros A E F E' F' q.
  assert (power o a q - power o' a q = 0); [|lra].
  rewrite power_difference. apply affine_zero with a b c; try assumption;
  rewrite <- power_difference; unfold power; lra.
Qed.

(* One centre serves for all: in and on the circle are signs of the power. *)
Ltac by_power o a b c :=
  intros A T C; pose proof (turned_positive _ _ _ _ T A) as A';
  rewrite (turned_centre _ _ _ _ _ T) in C; split;
  [ intros [o' [C' H]]; specialize (H a (proj2 (turned_corner _ _ _ _ _ T) (or_introl eq_refl)));
    rewrite (turned_centre _ _ _ _ _ T) in C';
    rewrite (centre_unique o o' a b c) by tauto; unfold power; lra
  | intros H; exists o; split; [apply (turned_centre _ _ _ _ _ T); assumption|]; intros x Hx;
    rewrite (turned_corner _ _ _ _ _ T) in Hx;
    unfold power in H; destruct Hx as [|[|]]; subst; lra ].

Lemma in_circle_power t a b c o p : positive t -> turned t a b c -> centre o t ->
  (in_circle p t <-> power o a p < 0).
Proof. by_power o a b c. Qed.

Lemma on_circle_power t a b c o p : positive t -> turned t a b c -> centre o t ->
  (on_circle p t <-> power o a p = 0).
Proof. by_power o a b c. Qed.

Lemma turned_centre_exists t : positive t -> exists o, centre o t.
Proof. destruct t as [[a b] c]; cbn; intros; apply centre_exists; assumption. Qed.

(* Inside a triangle is inside its circle. *)
Lemma interior_in_circle t a b c o q : turned t a b c -> centre o t -> in_interior q t -> power o a q < 0.
Proof.
  intros T C I. pose proof (turned_positive _ _ _ _ T (interior_positive _ _ I)) as A.
  rewrite (turned_centre _ _ _ _ _ T) in C. rewrite (turned_interior _ _ _ _ _ T) in I.
  destruct C as [E F]. destruct I as (H1 & H2 & H3).
  assert (H : circle a b c q = orient b c q * dist2 a q + orient c a q * dist2 b q + orient a b q * dist2 c q)
    by (unfold circle; flat; ring).
  assert (0 < circle a b c q).
  { rewrite H. pose proof (dist2_nonneg a q); pose proof (dist2_nonneg b q); pose proof (dist2_nonneg c q).
    assert (0 < dist2 a q).
    { destruct (Req_dec (dist2 a q) 0) as [Z|]; [exfalso|lra].
      apply dist2_zero in Z. subst q. pose proof (orient_same a b). lra. }
    assert (0 < orient b c q * dist2 a q) by nra.
    assert (0 <= orient c a q * dist2 b q) by nra.
    assert (0 <= orient a b q * dist2 c q) by nra. lra. }
  apply (circle_power_sign o) in H0; assumption.
Qed.

Lemma turned_three t a b c a' b' c' : turned t a b c -> turned t a' b' c' ->
  (a' = a /\ b' = b /\ c' = c) \/ (a' = b /\ b' = c /\ c' = a) \/ (a' = c /\ b' = a /\ c' = b).
Proof.
  intros [H|[H|H]] [H'|[H'|H']]; rewrite H in H'; injection H' as -> -> ->; auto.
Qed.
