(* The half-open count. A point q counts for a directed side if its x is from the left end's, inclusive, to the right
   end's, exclusive, and q is strictly above. Over the sides of a triangle that turns left the counts sum to 0 or 1,
   for every point of the plane: nothing has to be in general position. *)
Require Import Reals List Lra Psatz ZArith Permutation.
Require Import Spec Geometry.
Import ListNotations.
Open Scope R_scope.

Notation above := below_right.
Definition signed (a b q : point) : Z := (above a b q - above b a q)%Z.
Definition count (q : point) (t : triangle) : Z :=
  let '(a, b, c) := t in (signed a b q + signed b c q + signed c a q)%Z.

Lemma signed_odd a b q : signed b a q = (- signed a b q)%Z.
Proof. unfold signed. lia. Qed.

Lemma above_right a b q : X b <= X a -> above a b q = 0%Z.
Proof. intros. unfold above. destruct (Rle_dec _ _); [destruct (Rlt_dec _ _)|]; try reflexivity; lra. Qed.

Lemma above_bounds a b q : (0 <= above a b q <= 1)%Z.
Proof. unfold above. repeat destruct (Rle_dec _ _) || destruct (Rlt_dec _ _); lia. Qed.

Lemma mix_low f g h x y z : f <= 0 -> 0 < g -> 0 < h -> 0 < x + y + z -> x * f + y * g + z * h = 0 ->
  (y < 0 -> 0 < z) /\ (0 < z -> 0 <= y -> 0 <= x).
Proof.
  intros. split; intros.
  - destruct (Rlt_dec 0 z) as [|N]; [assumption|exfalso].
    assert (y * g < 0) by nra. assert (z * h <= 0) by nra. assert (0 < x * f) by lra. assert (x < 0) by nra. lra.
  - assert (0 <= y * g) by nra. assert (0 < z * h) by nra. assert (x * f < 0) by lra. nra.
Qed.

Lemma mix_high f g h x y z : 0 < f -> g <= 0 -> h <= 0 -> 0 < x + y + z -> x * f + y * g + z * h = 0 ->
  (z < 0 -> 0 < y) /\ (0 < y -> 0 <= z -> 0 <= x).
Proof.
  intros. split; intros.
  - destruct (Rlt_dec 0 y) as [|N]; [assumption|exfalso].
    assert (0 <= y * g) by nra. assert (0 <= z * h) by nra. assert (x * f <= 0) by lra. assert (x <= 0) by nra. lra.
  - assert (y * g <= 0) by nra. assert (z * h <= 0) by nra. assert (0 <= x * f) by lra. nra.
Qed.

(* Where a side counts is a matter of comparisons: all cases, each by arithmetic. *)
Ltac by_cases :=
  repeat match goal with |- context [Rlt_dec (X ?q) ?x] => destruct (Rlt_dec (X q) x); try lra end;
  repeat match goal with |- context [Rlt_dec 0 ?e] => destruct (Rlt_dec 0 e) end; try lra;
  (split; [lia|split; [try lia|try (intros; lra || lia)]]); intros _; repeat split; lra.

Lemma count_triangle q t : positive t ->
  (0 <= count q t <= 1)%Z /\ (count q t = 1%Z -> in_triangle q t) /\ (in_interior q t -> count q t = 1%Z).
Proof.
  destruct t as [[a b] c]. cbn [positive in_triangle in_interior count]. intros A.
  pose proof (orient_sum a b c q) as S.
  assert (E : orient b c q * (X a - X q) + orient c a q * (X b - X q) + orient a b q * (X c - X q) = 0)
    by (flat; ring).
  unfold signed, above.
  rewrite (orient_swap a b q), (orient_swap b c q), (orient_swap c a q).
  set (x := orient b c q) in *. set (y := orient c a q) in *. set (z := orient a b q) in *.
  set (f := X a - X q) in *. set (g := X b - X q) in *. set (h := X c - X q) in *.
  assert (A' : 0 < x + y + z) by lra.
  destruct (Rle_dec (X a) (X q)), (Rle_dec (X b) (X q)), (Rle_dec (X c) (X q)).
  - repeat (destruct (Rlt_dec (X q) _); try lra). split; [lia|split; [lia|]].
    intros (? & ? & ?). exfalso.
    assert (z * h <= 0) by (unfold h; nra). assert (x * f <= 0) by (unfold f; nra).
    assert (y * g <= 0) by (unfold g; nra).
    assert (f = 0) by nra. assert (g = 0) by nra. assert (h = 0) by nra.
    assert (orient a b c = (g - f) * (Y c - Y a) - (Y b - Y a) * (h - f)) by (unfold orient, f, g, h; ring).
    assert (orient a b c = 0) by (replace f with 0 in *; replace g with 0 in *; replace h with 0 in *; lra). lra.
  - pose proof (mix_high h f g z x y ltac:(unfold h; lra) ltac:(unfold f; lra) ltac:(unfold g; lra)
      ltac:(lra) ltac:(lra)) as [P Q].
    by_cases.
  - pose proof (mix_high g h f y z x ltac:(unfold g; lra) ltac:(unfold h; lra) ltac:(unfold f; lra)
      ltac:(lra) ltac:(lra)) as [P Q].
    by_cases.
  - pose proof (mix_low f g h x y z ltac:(unfold f; lra) ltac:(unfold g; lra) ltac:(unfold h; lra)
      ltac:(lra) ltac:(lra)) as [P Q].
    by_cases.
  - pose proof (mix_high f g h x y z ltac:(unfold f; lra) ltac:(unfold g; lra) ltac:(unfold h; lra)
      ltac:(lra) ltac:(lra)) as [P Q].
    by_cases.
  - pose proof (mix_low g h f y z x ltac:(unfold g; lra) ltac:(unfold h; lra) ltac:(unfold f; lra)
      ltac:(lra) ltac:(lra)) as [P Q].
    by_cases.
  - pose proof (mix_low h f g z x y ltac:(unfold h; lra) ltac:(unfold f; lra) ltac:(unfold g; lra)
      ltac:(lra) ltac:(lra)) as [P Q].
    by_cases.
  - repeat (destruct (Rlt_dec (X q) _); try lra); (split; [lia|split; [lia|]]);
    intros (? & ? & ?); exfalso.
    assert (0 < z * h) by (unfold h; nra). assert (0 < x * f) by (unfold f; nra). assert (0 < y * g) by (unfold g; nra).
    lra.
Qed.

(* Sums over lists. *)
Definition total {A} (f : A -> Z) (l : list A) : Z := fold_right (fun x s => (f x + s)%Z) 0%Z l.

Lemma total_cons {A} (f : A -> Z) x l : total f (x :: l) = (f x + total f l)%Z.
Proof. reflexivity. Qed.

Lemma total_app {A} (f : A -> Z) l m : total f (l ++ m) = (total f l + total f m)%Z.
Proof. induction l; cbn; [reflexivity|]. unfold total in *. rewrite IHl. lia. Qed.

Lemma total_permutation {A} (f : A -> Z) l m : Permutation l m -> total f l = total f m.
Proof. unfold total. induction 1; cbn [fold_right] in *; lia. Qed.

Lemma total_nonneg {A} (f : A -> Z) l : (forall x, In x l -> (0 <= f x)%Z) -> (0 <= total f l)%Z.
Proof.
  induction l as [|x l IH]; cbn; intros H; [lia|].
  pose proof (H x (or_introl eq_refl)). pose proof (IH (fun y Hy => H y (or_intror Hy))). unfold total in *. lia.
Qed.

Lemma total_member {A} (f : A -> Z) l x : (forall x, In x l -> (0 <= f x)%Z) -> In x l -> (f x <= total f l)%Z.
Proof.
  intros H I. apply in_split in I. destruct I as (l1 & l2 & ->).
  rewrite total_app. cbn.
  pose proof (total_nonneg f l1 (fun y Hy => H y (in_or_app l1 (x :: l2) y (or_introl Hy)))).
  pose proof (total_nonneg f l2 (fun y Hy => H y (in_or_app l1 (x :: l2) y (or_intror (or_intror Hy))))).
  unfold total in *. lia.
Qed.

Lemma total_two {A} (f : A -> Z) l : (forall x, In x l -> (0 <= f x)%Z) ->
  forall i j x y, i <> j -> nth_error l i = Some x -> nth_error l j = Some y -> (f x + f y <= total f l)%Z.
Proof.
  induction l as [|z l IH]; intros H [|i] [|j] x y N I J; cbn in I, J; try discriminate; try congruence.
  - injection I as ->. cbn. pose proof (total_member f l y (fun z Hz => H z (or_intror Hz)) (nth_error_In _ _ J)).
    unfold total in *. lia.
  - injection J as ->. cbn. pose proof (total_member f l x (fun z Hz => H z (or_intror Hz)) (nth_error_In _ _ I)).
    unfold total in *. lia.
  - cbn. assert (N' : i <> j) by congruence.
    pose proof (IH (fun z Hz => H z (or_intror Hz)) i j x y N' I J).
    pose proof (H z (or_introl eq_refl)). unfold total in *. lia.
Qed.

Lemma total_positive {A} (f : A -> Z) l : (0 < total f l)%Z -> exists x, In x l /\ (0 < f x)%Z.
Proof.
  induction l as [|x l IH]; cbn; intros H; [lia|].
  destruct (Z_lt_le_dec 0 (f x)) as [P|P]; [exists x; auto|].
  destruct IH as [y [I Q]]; [unfold total in *; lia|]. exists y; auto.
Qed.
