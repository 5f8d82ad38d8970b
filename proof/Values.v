(* Sums over the sides of all triangles, for the values of triangles and for the rings around them.

   A function of sides is *odd* if it changes its sign with the direction. Over the sides of a triangle it adds up to its
   *turn*. By summing value times turn, each side counts by how much the value rises across it. With the half-open count
   as the function, that is the winding number (Domain.v).

   By polygons the value is known to rise as it must across the first lower side of each triangle alone. At any other side
   there may be a *defect*. These sides have different left ends, since each takes its left end off the front, or is left
   on it. With differences of any function of points as the odd function, turns are 0, and so are the sums over closed
   rings. So the defects at the sides of each point add up to 0. The first of all left ends has one side with a
   defect alone, which is 0 then; and so on to the right. *)
Require Import ZArith List Lia Bool Permutation.
Require Import Geometry Count Sort Rings Check Place Laid.
Import ListNotations.
Open Scope Z_scope.

Definition is_odd (F : zpoint -> zpoint -> Z) : Prop := forall a b, F b a = - F a b.
Definition along (F : zpoint -> zpoint -> Z) (s : zside) : Z := F (left_end s) (right_end s).
Definition turn (F : zpoint -> zpoint -> Z) (t : ztriangle) : Z :=
  F (corner_a t) (corner_b t) + F (corner_b t) (corner_c t) + F (corner_c t) (corner_a t).

(* What the rises of one ring n add up to. *)
Definition weigh (G : zside -> Z) (n : Z) (x : zrise) : Z := if Z.eqb n (rise_ring x) then rise x * G (rise_side x) else 0.
Definition times (n : Z) (rs : list Z) : Z := total (fun r => if Z.eqb n r then 1 else 0) rs.

Lemma weigh_rise G n m v rs i l :
  total (weigh G n) (add_rise (Some m) v rs i l) = times n rs * G (item_side i) + total (weigh G n) l.
Proof.
  unfold times. cbn [add_rise]. revert l. induction rs as [|r rs IH]; intros l; cbn [fold_left]; [reflexivity|].
  rewrite IH, !total_cons. unfold weigh at 1. cbn [rise rise_ring rise_side]. destruct (Z.eqb n r); ring.
Qed.

Lemma weigh_value G v rs i l :
  total (weigh G 0) (add_rise None v rs i l) = (v - level i) * G (item_side i) + total (weigh G 0) l.
Proof.
  cbn [add_rise]. destruct (Z.eqb_spec v (level i)) as [->|N]; [ring|]. rewrite total_cons. reflexivity.
Qed.

Lemma total_map {A B} (f : B -> Z) (g : A -> B) l : total f (map g l) = total (fun x => f (g x)) l.
Proof. induction l as [|x l IH]; [reflexivity|]. cbn [map]. rewrite !total_cons, IH. reflexivity. Qed.

Lemma total_rev_append {A} (f : A -> Z) l acc : total f (rev_append l acc) = total f l + total f acc.
Proof. rewrite rev_append_rev, total_app, <- (total_permutation _ _ _ (Permutation_rev l)). reflexivity. Qed.

Lemma total_even {A} (f g : A -> Z) l : (forall x, In x l -> Z.Even (f x - g x)) -> Z.Even (total f l - total g l).
Proof.
  induction l as [|x l IH]; intros H; [exists 0; reflexivity|]. rewrite !total_cons.
  destruct (H x (or_introl eq_refl)) as [y Y]. destruct IH as [z W]; [intros; apply H; right; assumption|].
  exists (y + z). lia.
Qed.

(* Values that are compared across each side. *)
Section Compared.
Variable F : zpoint -> zpoint -> Z.
Hypothesis F_odd : is_odd F.

Definition seen (s : state) : Z := total (fun i => level i * along F (item_side i)) (front s) - total (weigh (along F) 0) (rises s).

Lemma step_value rule t s s' : step rule None t s = Some s' -> value t * turn F t + seen s' = seen s.
Proof.
  intros E. apply step_cases in E. cbn zeta in E. destruct E as (_ & i & Ei & _ & _ & E). unfold seen, turn.
  rewrite (F_odd (corner_a t) (corner_c t)).
  destruct E as [(r & P & _ & _ & P' & _ & _ & Ri) | (j & r & P & Ej & _ & P' & _ & _ & Ri)];
    rewrite Ri, (total_permutation _ _ _ P), (total_permutation _ _ _ P'), !weigh_value, !total_cons; cbn [item_side level];
    rewrite Ei; try rewrite Ej; unfold along; cbn [left_end right_end].
  - rewrite (F_odd (corner_b t) (corner_c t)). ring.
  - ring.
Qed.

Lemma grown_value rule low ends ts s : grown rule None low ends ts s -> total (fun t => value t * turn F t) ts + seen s = 0.
Proof.
  assert (A : forall x ps s s', adds x ps s s' -> seen s' = seen s).
  { intros x ps s1 s2 (_ & P & _ & _ & R). unfold seen. rewrite R, (total_permutation _ _ _ P), total_cons. reflexivity. }
  induction 1 as [|? ? ? ? ? ? _ IH S| ? ? ? ? _ IH S| ? ? ? ? ? ? ? _ IH _ S| ? ? ? ? ? ? ? _ IH _ S];
    [reflexivity| |rewrite (A _ _ _ _ S); assumption..].
  apply step_value in S. rewrite total_app, total_cons. cbn [total fold_right] in *. unfold total in *. cbn [fold_right]. lia.
Qed.
End Compared.

Lemma last_rises_value G : forall l acc, total (weigh G 0) (last_rises None l acc) =
  total (weigh G 0) acc - total (fun i => level i * G (item_side i)) l.
Proof.
  induction l as [|i l IH]; intros acc; cbn [last_rises]; [cbn; ring|]. rewrite IH, weigh_value, total_cons. ring.
Qed.

(* Rings. *)
Lemma flips_good m rs : forall w, good m w -> good m (fold_left (flip m) rs w).
Proof. induction rs as [|r rs IH]; intros w G; cbn [fold_left]; [assumption|]. apply IH, flip_good, G. Qed.

Lemma flips_parity m n rs : forall w, Z.Even (parity n (fold_left (flip m) rs w) - parity n w - times n rs).
Proof.
  unfold times. induction rs as [|r rs IH]; intros w; cbn [fold_left].
  - exists 0. cbn. ring.
  - destruct (IH (flip m w r)) as [z E]. rewrite flip_odd in E. rewrite total_cons. destruct (Z.eqb n r).
    + exists (z - parity n w). lia.
    + exists z. lia.
Qed.

(* A side with the defect of each ring there. *)
Definition defect : Type := zside * (Z -> Z).
Definition from_left (x : defect) : zpoint := left_end (fst x).
Definition goes_right (x : defect) : Prop := before (left_end (fst x)) (right_end (fst x)) = true.

Record ringed (m : table) (done : list (ztriangle * around)) (N : list defect) (rest : list zpoint) (s : state) : Prop := {
  r_done : forall x, In x done -> good m (snd x) /\ is_covered (snd x) = negb (Z.eqb (value (fst x)) 0);
  r_front : forall i, In i (front s) ->
    good m (beneath i) /\ before (left_end (item_side i)) (right_end (item_side i)) = true;
  r_defects : forall x, In x N -> goes_right x;
  r_ends : Permutation (map (fun i => left_end (item_side i)) (front s) ++ map from_left N ++ rest) (brought s);
  r_sum : forall n F, is_odd F -> Z.Even (total (fun x => parity n (snd x) * turn F (fst x)) done
    + total (fun i => parity n (beneath i) * along F (item_side i)) (front s)
    - total (weigh (along F) n) (rises s) - total (fun x : defect => snd x n * along F (fst x)) N)
}.

Lemma ringed_step rule m done N rest t s s' : ringed m done N rest s -> step rule (Some m) t s = Some s' ->
  exists w N', ringed m ((t, w) :: done) N' rest s'.
Proof.
  intros [D Fr Df En Su] E. apply step_cases in E. cbn zeta in E. destruct E as (_ & i & Ei & _ & W & E).
  set (w := enter (Some m) (rings_ab t) i) in *. exists w.
  assert (Told : is_covered w = negb (Z.eqb (value t) 0)) by (apply Bool.eqb_prop in W; exact W).
  assert (Par : forall n, Z.Even (parity n w - parity n (beneath i) - times n (rings_ab t)))
    by (intros n; apply flips_parity).
  destruct E as [(r & P & Bac & Bcb & P' & Br & _ & Ri) | (j & r & P & Ej & _ & P' & Br & _ & Ri)].
  - exists N.
    assert (Ii : In i (front s)) by (apply (Permutation_in _ (Permutation_sym P)); left; reflexivity).
    assert (Gw : good m w) by (apply flips_good; apply Fr; assumption).
    split.
    + intros x [<-|Hx]; [cbn; auto|apply D; assumption].
    + intros x Hx. apply (Permutation_in _ P') in Hx. destruct Hx as [<-|[<-|Hx]]; cbn; auto.
      apply Fr. apply (Permutation_in _ (Permutation_sym P)). right; assumption.
    + assumption.
    + rewrite Br, P'. rewrite P in En. cbn [map app item_side left_end] in *. rewrite Ei in En.
      cbn [left_end] in En. rewrite <- En. cbn [app]. apply perm_swap.
    + intros n F O. destruct (Su n F O) as [z Z]. destruct (Par n) as [y Y].
      exists (z + y * F (corner_a t) (corner_b t)). rewrite Z.mul_add_distr_l, <- Z.
      rewrite Ri, (weigh_rise (along F) n m).
      rewrite (total_permutation _ _ _ P), (total_permutation _ _ _ P'), !total_cons. cbn [fst snd item_side beneath].
      rewrite Ei. unfold turn, along. cbn [left_end right_end].
      rewrite (O (corner_a t) (corner_c t)), (O (corner_b t) (corner_c t)).
      replace (parity n w) with (parity n (beneath i) + times n (rings_ab t) + 2 * y) by lia. ring.
  - exists ((item_side j, fun n => parity n w - parity n (beneath j) - times n (rings_bc t)) :: N).
    assert (Ii : In i (front s)) by (apply (Permutation_in _ (Permutation_sym P)); left; reflexivity).
    assert (Ij : In j (front s)) by (apply (Permutation_in _ (Permutation_sym P)); right; left; reflexivity).
    assert (Gw : good m w) by (apply flips_good; apply Fr; assumption).
    destruct (Fr i Ii) as [_ Bi]. destruct (Fr j Ij) as [_ Bj].
    split.
    + intros x [<-|Hx]; [cbn; auto|apply D; assumption].
    + intros x Hx. apply (Permutation_in _ P') in Hx. destruct Hx as [<-|Hx]; cbn.
      * split; [assumption|]. rewrite Ei in Bi. rewrite Ej in Bj. cbn in Bi, Bj.
        rewrite before_spec in *. lia.
      * apply Fr. apply (Permutation_in _ (Permutation_sym P)). right; right; assumption.
    + intros x [<-|Hx]; [exact Bj|apply Df; assumption].
    + rewrite Br, P'. rewrite P in En. cbn [map app item_side left_end] in *. rewrite Ei in En.
      cbn [left_end] in En. unfold from_left at 1. cbn [fst]. rewrite <- En. constructor.
      symmetry. apply Permutation_middle.
    + intros n F O. destruct (Su n F O) as [z Z]. destruct (Par n) as [y Y].
      exists (z + y * F (corner_a t) (corner_b t)). rewrite Z.mul_add_distr_l, <- Z.
      rewrite Ri, !(weigh_rise (along F) n m).
      rewrite (total_permutation _ _ _ P), (total_permutation _ _ _ P'), !total_cons. cbn [fst snd item_side beneath].
      rewrite Ei, Ej. unfold turn, along. cbn [left_end right_end].
      rewrite (O (corner_a t) (corner_c t)).
      replace (parity n w) with (parity n (beneath i) + times n (rings_ab t) + 2 * y) by lia. ring.
Qed.

Lemma ringed_lower m done N rest rest' x ps s s' : ringed m done N rest s -> adds x ps s s' ->
  Permutation (left_end x :: rest') (ps ++ rest) -> ringed m done N rest' s'.
Proof.
  intros [D Fr Df En Su] (B & P & Br & _ & Ri) E. split; try assumption.
  - intros i Hi. apply (Permutation_in _ P) in Hi. destruct Hi as [<-|Hi]; [|auto]. split; [apply outside_good|exact B].
  - rewrite Br, P, <- En. cbn [map app first_item item_side].
    rewrite (Permutation_app_comm ps), <- !app_assoc, (Permutation_app_comm rest), <- E, <- !Permutation_middle. reflexivity.
  - intros n F O. rewrite Ri, (total_permutation _ _ _ P), total_cons.
    assert (Zero : parity n (beneath (first_item x)) = 0); [|rewrite Zero; apply Su; assumption].
    unfold parity, has. cbn [first_item beneath outside odd]. rewrite PM.mem_find, PM.gempty. reflexivity.
Qed.

Lemma grown_ringed rule m low ends ts s : grown rule (Some m) low ends ts s ->
  exists done N, ringed m done N match ends with Some (_, l) => [right_end l] | None => [] end s /\
    Permutation (map fst done) ts.
Proof.
  induction 1 as [|low ends ts s t s' _ (done & N & R & P) S|ts s x s' _ (done & N & R & P) A
    |low f l ts s x s' _ (done & N & R & P) J A|low f l ts s x s' _ (done & N & R & P) J A].
  - exists [], []. split; [|reflexivity]. split; try (intros; contradiction); [reflexivity|]. intros n F _. exists 0. reflexivity.
  - apply (ringed_step _ _ _ _ _ _ _ _ R) in S. destruct S as (w & N' & R'). exists ((t, w) :: done), N'. split; [assumption|].
    cbn [map fst]. rewrite P. apply Permutation_cons_append.
  - exists done, N. split; [|assumption]. apply (ringed_lower _ _ _ _ _ _ _ _ _ R A). reflexivity.
  - exists done, N. split; [|assumption]. apply (ringed_lower _ _ _ _ _ _ _ _ _ R A). reflexivity.
  - exists done, N. split; [|assumption]. apply (ringed_lower _ _ _ _ _ _ _ _ _ R A).
    apply andb_prop in J. destruct J as [J _]. apply same_eq in J. rewrite J. apply perm_swap.
Qed.

Lemma first_defect : forall M : list defect, M <> [] ->
  exists x M', Permutation M (x :: M') /\ forall y, In y M' -> before (from_left y) (from_left x) = false.
Proof.
  induction M as [|z M IH]; intros N; [congruence|]. destruct M as [|z' M].
  - exists z, []. split; [reflexivity|]. intros y [].
  - destruct IH as (x & M' & P & L); [discriminate|]. destruct (before (from_left z) (from_left x)) eqn:B.
    + exists z, (x :: M'). split; [rewrite P; reflexivity|]. intros y [<-|Y].
      * apply not_true_is_false. rewrite before_spec in *. lia.
      * specialize (L y Y). apply not_true_is_false. intros C. apply not_true_iff_false in L. apply L.
        rewrite before_spec in *. lia.
    + exists x, (z :: M'). split; [rewrite P; apply perm_swap|]. intros y [<-|Y]; auto.
Qed.

(* From left to right, there is no defect. *)
Lemma defects_vanish n : forall k (M : list defect), (length M <= k)%nat -> (forall x, In x M -> goes_right x) ->
  NoDup (map from_left M) ->
  (forall f : zpoint -> Z, Z.Even (total (fun x : defect => snd x n * (f (right_end (fst x)) - f (left_end (fst x)))) M)) ->
  forall x, In x M -> Z.Even (snd x n).
Proof.
  induction k as [|k IH]; intros M L R D E x I; [destruct M; [destruct I|cbn in L; lia]|].
  destruct (first_defect M) as (z & M' & P & First); [destruct M; [destruct I|discriminate]|].
  assert (RM : forall y, In y M' -> goes_right y) by (intros; apply R, (Permutation_in _ (Permutation_sym P)); right; assumption).
  assert (RZ : goes_right z) by (apply R, (Permutation_in _ (Permutation_sym P)); left; reflexivity).
  apply (Permutation_NoDup (Permutation_map from_left P)) in D. cbn [map] in D. apply NoDup_cons_iff in D. destruct D as [NZ D].
  assert (EZ : Z.Even (snd z n)).
  { destruct (E (fun p => if same p (from_left z) then 1 else 0)) as [y Y].
    rewrite (total_permutation _ _ _ P), total_cons in Y. cbv beta in Y.
    assert (S : forall p, same p (from_left z) = true -> p = from_left z) by (intros p; apply same_eq).
    assert (Rest : total (fun x : defect => snd x n * ((if same (right_end (fst x)) (from_left z) then 1 else 0)
      - (if same (left_end (fst x)) (from_left z) then 1 else 0))) M' = 0).
    { clear Y. revert RM First NZ. clear - S. induction M' as [|v M' IH]; intros RM First NZ; [reflexivity|]. rewrite total_cons, IH.
      - destruct (same (left_end (fst v)) (from_left z)) eqn:A.
        { apply S in A. destruct NZ. left. exact A. }
        destruct (same (right_end (fst v)) (from_left z)) eqn:B; [|ring].
        apply S in B. pose proof (RM v (or_introl eq_refl)) as G. pose proof (First v (or_introl eq_refl)) as H.
        unfold goes_right in G. rewrite B in G. unfold from_left at 1 in H. congruence.
      - intros; apply RM; right; assumption.
      - intros; apply First; right; assumption.
      - intros C. apply NZ. right. exact C. }
    rewrite Rest in Y. change (left_end (fst z)) with (from_left z) in Y. rewrite same_refl in Y.
    destruct (same (right_end (fst z)) (from_left z)) eqn:B.
    { apply S in B. unfold goes_right in RZ. unfold from_left in B. rewrite B, before_spec in RZ. lia. }
    exists (- y). lia. }
  apply (Permutation_in _ P) in I. destruct I as [<-|I]; [assumption|].
  apply (IH M'); try assumption.
  - apply Permutation_length in P. cbn in P. lia.
  - intros f. destruct (E f) as [y Y]. destruct EZ as [v V]. rewrite (total_permutation _ _ _ P), total_cons in Y.
    rewrite V in Y. exists (y - v * (f (right_end (fst z)) - f (left_end (fst z)))). lia.
Qed.

(* The edges: an odd function that adds up along them. *)
Definition adds_up (F : zpoint -> zpoint -> Z) : Prop := forall a v b, inside a v b = true -> F a b = F a v + F v b.

(* The edges of ring n. *)
Definition in_ring (ring_of : zedge -> option Z) (n : Z) (e : zedge) : bool :=
  match ring_of e with
  | Some m => Z.eqb n m
  | None => false
  end.
Definition round_ring (F : zpoint -> zpoint -> Z) (ring_of : zedge -> option Z) (n : Z) (es : list zedge) : Z :=
  total (fun e => F (edge_from e) (edge_to e)) (filter (in_ring ring_of n) es).

Section Edges.
Variable F : zpoint -> zpoint -> Z.
Hypothesis F_odd : is_odd F.
Hypothesis F_adds : adds_up F.

Lemma fall_weight n m a b : weigh (along F) n (fall m a b) = if Z.eqb n m then - F a b else 0.
Proof.
  pose proof (F_odd a b). unfold fall, weigh, along.
  destruct (before a b); cbn [rise rise_ring rise_side left_end right_end]; destruct (Z.eqb n m); lia.
Qed.

Lemma falls_of_total n m b : forall through a acc0 l acc, pieces_of a through b acc0 = Some l ->
  total (weigh (along F) n) (falls_of m a through b acc) =
    total (weigh (along F) n) acc - if Z.eqb n m then F a b else 0.
Proof.
  induction through as [|v r IH]; cbn [pieces_of falls_of]; intros a acc0 l acc H.
  - rewrite total_cons, fall_weight. destruct (Z.eqb n m); ring.
  - destruct (inside a v b) eqn:V; [|discriminate]. rewrite (IH _ _ _ _ H), total_cons, fall_weight.
    rewrite (F_adds a v b V). destruct (Z.eqb n m); ring.
Qed.

Lemma falls_total ring_of n : forall es acc0 l acc, pieces es acc0 = Some l ->
  total (weigh (along F) n) (falls ring_of es acc) = total (weigh (along F) n) acc - round_ring F ring_of n es.
Proof.
  unfold round_ring. induction es as [|e r IH]; intros acc0 l acc H.
  - cbn [falls filter]. unfold total. cbn [fold_right]. lia.
  - cbn [pieces falls filter] in *. unfold in_ring at 1.
    destruct (same (edge_from e) (edge_to e)) eqn:S.
    + apply same_eq in S. assert (Zero : F (edge_from e) (edge_to e) = 0).
      { rewrite S. pose proof (F_odd (edge_to e) (edge_to e)). lia. }
      destruct (ring_of e) as [m|]; [destruct (Z.eqb n m)|]; rewrite (IH _ _ _ H), ?total_cons; lia.
    + destruct (pieces_of _ _ _ acc0) as [acc1|] eqn:P; [|discriminate].
      destruct (ring_of e) as [m|]; [|apply (IH _ _ _ H)]. rewrite (IH _ _ _ H).
      rewrite (falls_of_total n m _ _ _ _ _ acc P). destruct (Z.eqb n m); rewrite ?total_cons; ring.
Qed.
End Edges.

(* Sums over the sides that balance: what fits each side and ring fits all. *)
Lemma compare_rises_eq x y : compare_rises x y = Eq -> rise_side x = rise_side y /\ rise_ring x = rise_ring y.
Proof.
  unfold compare_rises. destruct (compare_sides _ _) eqn:S; try discriminate. intros R.
  apply compare_sides_eq in S. apply Z.compare_eq in R. auto.
Qed.

Lemma balanced_total G (fits : Z -> bool) (good : Z -> Prop) n :
  (forall x k, fits x = true -> good (x * k)) -> (forall x y, good x -> good y -> good (x + y)) ->
  forall l x sum, balanced fits x sum l = true ->
    good (weigh G n (Rise (rise_side x) (rise_ring x) sum) + total (weigh G n) l).
Proof.
  intros Times Plus. assert (Fits : forall x sum, fits sum = true ->
    good (weigh G n (Rise (rise_side x) (rise_ring x) sum))).
  { intros x sum F. unfold weigh. cbn [rise rise_ring rise_side]. destruct (Z.eqb _ _); [apply Times; assumption|].
    replace 0 with (sum * 0) by ring. apply Times; assumption. }
  induction l as [|y l IH]; cbn [balanced]; intros x sum H.
  - cbn [total fold_right]. rewrite Z.add_0_r. apply Fits; assumption.
  - rewrite total_cons.
    assert (K : fits sum && balanced fits y (rise y) l = true ->
      good (weigh G n (Rise (rise_side x) (rise_ring x) sum) + (weigh G n y + total (weigh G n) l))).
    { intros K. apply andb_prop in K. destruct K as [K1 K2]. apply Plus; [apply Fits; assumption|].
      apply IH in K2. destruct y. exact K2. }
    destruct (compare_rises x y) eqn:C; [|apply K; assumption|apply K; assumption].
    apply compare_rises_eq in C. destruct C as [S R]. apply IH in H.
    replace (weigh G n (Rise (rise_side x) (rise_ring x) sum) + (weigh G n y + total (weigh G n) l))
      with (weigh G n (Rise (rise_side x) (rise_ring x) (sum + rise y)) + total (weigh G n) l); [assumption|].
    unfold weigh. cbn [rise rise_ring rise_side]. rewrite S, R. destruct (Z.eqb n (rise_ring y)); ring.
Qed.

Lemma all_balanced_total G (fits : Z -> bool) (good : Z -> Prop) n l : good 0 ->
  (forall x k, fits x = true -> good (x * k)) -> (forall x y, good x -> good y -> good (x + y)) ->
  all_balanced fits l = true -> good (total (weigh G n) l).
Proof.
  intros Zero Times Plus H. unfold all_balanced in H.
  rewrite <- (total_permutation _ _ _ (sort_permutes compare_rises l)).
  destruct (sort _ l) as [|x r]; [assumption|]. rewrite total_cons.
  apply (balanced_total G fits good n Times Plus) in H. destruct x. exact H.
Qed.

Lemma all_even G n l : all_balanced Z.even l = true -> Z.Even (total (weigh G n) l).
Proof.
  apply all_balanced_total.
  - exists 0; reflexivity.
  - intros x y X. apply Z.even_spec in X. destruct X as [z ->]. exists (z * y). ring.
  - intros x y [z ->] [w ->]. exists (z + w). ring.
Qed.

(* Closed rings. *)
Lemma ends_total (f : zpoint -> Z) n : forall es acc, total (weigh (fun s => f (left_end s)) n) (ends es acc) =
  total (weigh (fun s => f (left_end s)) n) acc
  + total (fun e => f (edge_from e) + f (edge_to e)) (filter (in_ring edge_ring n) es).
Proof.
  induction es as [|e r IH]; intros acc; cbn [ends filter]; [unfold total; cbn [fold_right]; lia|]. unfold in_ring at 1.
  destruct (edge_ring e) as [m|]; [|apply IH]. rewrite IH, !total_cons. unfold weigh at 1 2.
  cbn [rise rise_ring rise_side left_end]. destruct (Z.eqb n m); rewrite ?total_cons; ring.
Qed.

Lemma closed_even (f : zpoint -> Z) n es : all_balanced Z.even (ends es []) = true ->
  Z.Even (round_ring (fun a b => f b - f a) edge_ring n es).
Proof.
  intros H. apply (all_even (fun s => f (left_end s)) n) in H. rewrite ends_total in H. unfold round_ring.
  destruct (total_even (fun e => f (edge_to e) - f (edge_from e)) (fun e => f (edge_from e) + f (edge_to e))
    (filter (in_ring edge_ring n) es)) as [z E].
  { intros e _. exists (- f (edge_from e)). ring. }
  destruct H as [y Y]. exists (z + y). cbn [total fold_right] in *. cbn beta in *. lia.
Qed.

Lemma last_rises_rings m G n : forall l acc, total (weigh G n) (last_rises (Some m) l acc) =
  total (weigh G n) acc + total (fun i => times n (last_rings i) * G (item_side i)) l.
Proof.
  induction l as [|i l IH]; intros acc; cbn [last_rises]; [unfold total; cbn [fold_right]; lia|].
  rewrite IH, (weigh_rise G n m), total_cons. ring.
Qed.

(* What the checker says of rings, once all is laid. *)
Theorem rings_right m done N rest s fr es ps : ringed m done N rest s -> Permutation (front s) fr -> NoDup (brought s) ->
  pieces es [] = Some ps -> all_balanced Z.even (rev_append (falls edge_ring es []) (last_rises (Some m) fr (rises s))) = true ->
  all_balanced Z.even (ends es []) = true ->
  forall n F, is_odd F -> adds_up F ->
    Z.Even (total (fun x => parity n (snd x) * turn F (fst x)) done - round_ring F edge_ring n es).
Proof.
  intros [_ Fr Df En Su] P D PS B C n.
  set (M := (map (fun i => (item_side i, fun n => - parity n (beneath i) - times n (last_rings i))) (front s)
    ++ N : list defect)%list).
  assert (E : forall F, is_odd F -> adds_up F ->
    Z.Even (total (fun x => parity n (snd x) * turn F (fst x)) done - round_ring F edge_ring n es
      - total (fun x : defect => snd x n * along F (fst x)) M)).
  { intros F O A. destruct (Su n F O) as [z Z]. apply (all_even (along F) n) in B.
    rewrite total_rev_append, (falls_total F O A _ _ _ _ _ _ PS), last_rises_rings in B.
    change (total (weigh (along F) n) []) with 0 in B. destruct B as [y Y].
    rewrite <- (total_permutation _ _ _ P) in Y. exists (z + y). unfold M. rewrite total_app, total_map. cbn [fst snd].
    assert (T : total (fun i => (- parity n (beneath i) - times n (last_rings i)) * along F (item_side i)) (front s)
      = - total (fun i => parity n (beneath i) * along F (item_side i)) (front s)
        - total (fun i => times n (last_rings i) * along F (item_side i)) (front s)).
    { clear. induction (front s) as [|i l IH]; [reflexivity|]. rewrite !total_cons, IH. ring. }
    rewrite T. lia. }
  assert (V : forall x, In x M -> Z.Even (snd x n)).
  { apply (defects_vanish n (length M)); [reflexivity| | |].
    - intros x I. unfold M in I. apply in_app_or in I. destruct I as [I|I]; [|apply Df; assumption].
      apply in_map_iff in I. destruct I as (i & <- & I). apply (Fr i I).
    - assert (Q : NoDup ((map (fun i => left_end (item_side i)) (front s) ++ map from_left N) ++ rest)).
      { rewrite <- app_assoc. apply (Permutation_NoDup (Permutation_sym En)). assumption. }
      assert (Left : forall (a b : list zpoint), NoDup (a ++ b) -> NoDup a).
      { clear. induction a as [|x a IH]; intros b H; [constructor|]. cbn in H. apply NoDup_cons_iff in H.
        destruct H as [H1 H2]. constructor; [|apply (IH b); assumption]. intros I. apply H1, in_or_app. auto. }
      apply Left in Q. unfold M. rewrite map_app, map_map. exact Q.
    - intros f. destruct (E (fun a b => f b - f a)) as [z Z].
      + intros a b. ring.
      + intros a v b _. ring.
      + destruct (closed_even f n es C) as [y Y].
        assert (T : total (fun x => parity n (snd x) * turn (fun a b => f b - f a) (fst x)) done = 0).
        { clear. induction done as [|x l IH]; [reflexivity|]. rewrite total_cons, IH. unfold turn. ring. }
        rewrite T in Z. exists (- z - y). unfold along in Z. cbv beta in Z. lia. }
  intros F O A. destruct (E F O A) as [z Z].
  destruct (total_even (fun x : defect => snd x n * along F (fst x)) (fun _ => 0) M) as [y Y].
  { intros x I. destruct (V x I) as [v ->]. exists (v * along F (fst x)). ring. }
  assert (T : total (fun _ : defect => 0) M = 0) by (clear; induction M as [|x l IH]; [reflexivity|]; rewrite total_cons; lia).
  exists (z + y). lia.
Qed.
