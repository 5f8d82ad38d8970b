(* Which polygons cover a triangle, from the rings that go round it an odd number of times.

   From one side of an edge to the other one ring comes or goes. So what holds on the other side is made from what holds on
   this one, in steps of the logarithm of the number of rings. Trees of Coq's library are shared, never changed: so each
   side of the front has what holds below it, at the price of what changed. *)
Require Import ZArith List Bool Lia FMapPositive.
Import ListNotations.
Open Scope Z_scope.
Module PM := PositiveMap.

Record zpolygon := ZPolygon { outlines : list Z; holes : list Z }.

(* A name for each ring that is a positive number. *)
Definition key (r : Z) : positive := match r with Z0 => 1 | Zpos p => p~0 | Zneg p => p~1 end.

(* For each ring the polygons that it is part of, by their places, and whether it is a hole there. *)
Definition table : Type := PM.t (list (positive * bool)).
Definition roles (m : table) (k : positive) : list (positive * bool) :=
  match PM.find k m with Some l => l | None => [] end.
Definition add_roles (p : positive) (hole : bool) (l : list Z) (m : table) : table :=
  fold_left (fun m r => PM.add (key r) ((p, hole) :: roles m (key r)) m) l m.
Fixpoint table_of (p : positive) (ps : list zpolygon) (m : table) : table :=
  match ps with
  | [] => m
  | g :: r => table_of (Pos.succ p) r (add_roles p true (holes g) (add_roles p false (outlines g) m))
  end.

(* What goes round a triangle: the rings; of each polygon the outlines and the holes; the polygons that cover it. *)
Definition rings : Type := PM.t unit.
Record around := Around { odd : rings; parts : PM.t (rings * rings); covering : rings }.
Definition outside : around := Around (PM.empty _) (PM.empty _) (PM.empty _).

Definition has (k : positive) (m : rings) : bool := PM.mem k m.
Definition put (on : bool) (k : positive) (m : rings) : rings := if on then PM.add k tt m else PM.remove k m.
Definition part (p : positive) (w : around) : rings * rings :=
  match PM.find p (parts w) with Some g => g | None => (PM.empty _, PM.empty _) end.
Definition is_cover (g : rings * rings) : bool := negb (PM.is_empty (fst g)) && PM.is_empty (snd g).

Definition put_role (on : bool) (k : positive) (w : around) (role : positive * bool) : around :=
  let (p, hole) := role in
  let (o, h) := part p w in
  let g := if hole then (o, put on k h) else (put on k o, h) in
  Around (odd w) (PM.add p g (parts w)) (put (is_cover g) p (covering w)).

(* Ring r comes or goes. *)
Definition flip (m : table) (w : around) (r : Z) : around :=
  let k := key r in
  let on := negb (has k (odd w)) in
  fold_left (put_role on k) (roles m k) (Around (put on k (odd w)) (parts w) (covering w)).

Definition is_covered (w : around) : bool := negb (PM.is_empty (covering w)).

(* The proof. *)
Lemma has_put on k m j : has j (put on k m) = if Pos.eqb j k then on else has j m.
Proof.
  unfold has, put. rewrite !PM.mem_find. destruct (Pos.eqb_spec j k) as [->|N], on.
  - rewrite PM.gss. reflexivity.
  - rewrite PM.grs. reflexivity.
  - rewrite PM.gso by assumption. reflexivity.
  - rewrite PM.gro by assumption. reflexivity.
Qed.

Lemma empty_has (m : rings) : PM.is_empty m = true <-> forall k, has k m = false.
Proof.
  unfold has. split.
  - intros H k. apply PM.is_empty_2 in H. rewrite PM.mem_find. destruct (PM.find k m) eqn:F; [|reflexivity].
    apply PM.find_2 in F. destruct (H k u F).
  - intros H. apply PM.is_empty_1. intros k e M. apply PM.find_1 in M. specialize (H k). rewrite PM.mem_find, M in H.
    discriminate.
Qed.

Lemma not_empty_has (m : rings) : PM.is_empty m = false <-> exists k, has k m = true.
Proof.
  split.
  - intros H. unfold has. induction m as [|l IHl o r IHr]; [discriminate|]. cbn in H. destruct o as [x|].
    + exists xH. reflexivity.
    + destruct (PM.is_empty l); cbn in H.
      * destruct (IHr H) as [k K]. exists k~1%positive. exact K.
      * destruct (IHl eq_refl) as [k K]. exists k~0%positive. exact K.
  - intros [k K]. destruct (PM.is_empty m) eqn:E; [|reflexivity]. rewrite (proj1 (empty_has m) E) in K. discriminate.
Qed.

(* The rings of polygon p that go round, of one kind. *)
Definition ones (hole : bool) (g : rings * rings) : rings := if hole then snd g else fst g.

Definition fits (w : around) : Prop := forall p, has p (covering w) = is_cover (part p w).

Lemma part_add p q g w : part q (Around (odd w) (PM.add p g (parts w)) (covering w)) = if Pos.eqb q p then g else part q w.
Proof.
  unfold part. cbn [parts]. destruct (Pos.eqb_spec q p) as [->|N]; [rewrite PM.gss|rewrite PM.gso by assumption];
    reflexivity.
Qed.

Lemma part_put_role on k w p hole q : part q (put_role on k w (p, hole)) =
  if Pos.eqb q p
  then let (o, h) := part p w in if hole then (o, put on k h) else (put on k o, h)
  else part q w.
Proof.
  unfold put_role. destruct (part p w) as [o h]. unfold part at 1. cbn [parts].
  destruct (Pos.eqb_spec q p) as [->|N]; [rewrite PM.gss|rewrite PM.gso by assumption]; reflexivity.
Qed.

Lemma put_role_fits on k w role : fits w -> fits (put_role on k w role).
Proof.
  destruct role as [p hole]. intros H q. rewrite part_put_role. unfold put_role. destruct (part p w) as [o h].
  cbn [covering]. rewrite has_put. destruct (Pos.eqb q p); [reflexivity|apply H].
Qed.

Lemma has_put_role on k w p hole q kind j : has j (ones kind (part q (put_role on k w (p, hole)))) =
  if Pos.eqb q p && Bool.eqb kind hole && Pos.eqb j k then on else has j (ones kind (part q w)).
Proof.
  rewrite part_put_role. destruct (Pos.eqb_spec q p) as [->|N]; [|reflexivity].
  destruct (part p w) as [o h], hole, kind; cbn [ones fst snd Bool.eqb andb]; rewrite ?has_put; reflexivity.
Qed.

Lemma put_roles on k : forall l w, fits w ->
  let w' := fold_left (put_role on k) l w in
  fits w' /\ odd w' = odd w /\ forall q kind j, has j (ones kind (part q w')) = true <->
    (j = k /\ In (q, kind) l /\ on = true) \/
    (~ (j = k /\ In (q, kind) l) /\ has j (ones kind (part q w)) = true).
Proof.
  induction l as [|[p hole] l IH]; intros w F; cbn [fold_left In].
  - split; [assumption|]. split; [reflexivity|]. intros. tauto.
  - destruct (IH (put_role on k w (p, hole))) as (F' & O & H); [apply put_role_fits; assumption|].
    split; [assumption|]. split.
    + rewrite O. unfold put_role. destruct (part p w). reflexivity.
    + intros q kind j. rewrite H, has_put_role.
      assert (E : Pos.eqb q p && Bool.eqb kind hole && Pos.eqb j k = true <-> (p, hole) = (q, kind) /\ j = k).
      { rewrite !andb_true_iff, !Pos.eqb_eq, Bool.eqb_true_iff. split; [intros ((-> & ->) & ->); auto|].
        intros (E & ->). injection E as -> ->. auto. }
      destruct (Pos.eqb q p && Bool.eqb kind hole && Pos.eqb j k).
      * destruct (proj1 E eq_refl) as (E1 & E2). cbv iota.
        assert (D : In (q, kind) l \/ ~ In (q, kind) l).
        { assert (Eq_dec : forall x y : positive * bool, {x = y} + {x <> y})
            by (decide equality; [apply bool_dec|apply Pos.eq_dec]).
          destruct (in_dec Eq_dec (q, kind) l); auto. }
        destruct on; [tauto|]. split; [|tauto]. intros [(_ & _ & C)|(_ & C)]; discriminate.
      * assert (N : ~ ((p, hole) = (q, kind) /\ j = k)) by (intros D; apply E in D; discriminate).
        cbv iota. tauto.
Qed.

(* What holds of all that the checker makes: the parts are the rings that go round, each in its roles. *)
Record good (m : table) (w : around) : Prop := {
  g_fits : fits w;
  g_parts : forall q kind j, has j (ones kind (part q w)) = true <-> has j (odd w) = true /\ In (q, kind) (roles m j)
}.

Lemma outside_good m : good m outside.
Proof.
  split.
  - intros p. unfold has, is_cover, part, outside. cbn [covering parts]. rewrite PM.gempty, PM.mem_find, PM.gempty.
    reflexivity.
  - intros q kind j. unfold part, outside, has. cbn [parts odd]. rewrite PM.gempty.
    destruct kind; cbn [ones fst snd]; rewrite PM.mem_find, PM.gempty; split; try discriminate; intros [D _]; discriminate.
Qed.

Lemma flip_good m w r : good m w -> good m (flip m w r).
Proof.
  intros [F P]. unfold flip. set (k := key r). set (on := negb (has k (odd w))).
  destruct (put_roles on k (roles m k) (Around (put on k (odd w)) (parts w) (covering w))) as (F' & O & H); [exact F|].
  split; [assumption|]. intros q kind j. rewrite H, O. cbn [odd]. rewrite has_put.
  change (part q (Around (put on k (odd w)) (parts w) (covering w))) with (part q w). rewrite P.
  destruct (Pos.eqb_spec j k) as [->|N]; tauto.
Qed.

Lemma key_injective r s : key r = key s -> r = s.
Proof. destruct r, s; cbn; intros E; try discriminate; congruence. Qed.

(* 1 if ring n goes round, else 0. *)
Definition parity (n : Z) (w : around) : Z := if has (key n) (odd w) then 1 else 0.

Lemma flip_odd m w r n : parity n (flip m w r) = if Z.eqb n r then 1 - parity n w else parity n w.
Proof.
  unfold parity, flip. set (k := key r). set (on := negb (has k (odd w))).
  assert (O : forall l v, odd (fold_left (put_role on k) l v) = odd v).
  { induction l as [|[p hole] l IH]; intros v; cbn [fold_left]; [reflexivity|]. rewrite IH. unfold put_role.
    destruct (part p v). reflexivity. }
  rewrite O. cbn [odd]. rewrite has_put. unfold on, k.
  destruct (Z.eqb_spec n r) as [->|N].
  - rewrite Pos.eqb_refl. destruct (has (key r) (odd w)); reflexivity.
  - destruct (Pos.eqb_spec (key n) (key r)) as [E|_]; [apply key_injective in E; congruence|reflexivity].
Qed.

(* The roles are those of the polygons. *)
Lemma add_roles_spec p hole : forall l m k x, In x (roles (add_roles p hole l m) k) <->
  (x = (p, hole) /\ exists r, In r l /\ key r = k) \/ In x (roles m k).
Proof.
  induction l as [|r l IH]; intros m k x; cbn [add_roles fold_left In]; [firstorder|].
  fold (add_roles p hole l (PM.add (key r) ((p, hole) :: roles m (key r)) m)). rewrite IH.
  unfold roles at 1. destruct (Pos.eq_dec k (key r)) as [->|N].
  - rewrite PM.gss. cbn [In]. split.
    + intros [(-> & s & S & E)|[<-|H]]; eauto 7.
    + intros [(-> & s & [<-|S] & E)|H]; eauto 7.
  - rewrite PM.gso by assumption. fold (roles m k). split.
    + intros [(-> & s & S & E)|H]; eauto 7.
    + intros [(-> & s & [<-|S] & E)|H]; [congruence| |auto]. left. eauto 7.
Qed.

Definition kind_of (hole : bool) (g : zpolygon) : list Z := if hole then holes g else outlines g.

Fixpoint numbered (p : positive) (ps : list zpolygon) : list (positive * zpolygon) :=
  match ps with
  | [] => []
  | g :: r => (p, g) :: numbered (Pos.succ p) r
  end.

Lemma numbered_least q g : forall ps p, In (q, g) (numbered p ps) -> (p <= q)%positive.
Proof.
  induction ps as [|h r IH]; cbn; intros p H; [destruct H|].
  destruct H as [E|H]; [injection E as -> _; reflexivity|]. apply IH in H. lia.
Qed.

Lemma numbered_once q g h : forall ps p, In (q, g) (numbered p ps) -> In (q, h) (numbered p ps) -> g = h.
Proof.
  induction ps as [|x r IH]; cbn; intros p G H; [destruct G|].
  destruct G as [G|G], H as [H|H]; try congruence; [| |eapply IH; eassumption].
  - injection G as <- <-. apply numbered_least in H. lia.
  - injection H as <- <-. apply numbered_least in G. lia.
Qed.

Lemma numbered_all g : forall ps p, In g ps <-> exists q, In (q, g) (numbered p ps).
Proof.
  induction ps as [|x r IH]; intros p; cbn [numbered In]; [firstorder|]. rewrite (IH (Pos.succ p)). split.
  - intros [->|[q Q]]; eauto.
  - intros [q [E|Q]]; [injection E as _ ->; auto|eauto].
Qed.

Lemma table_of_spec q hole k : forall ps p m, In (q, hole) (roles (table_of p ps m) k) <->
  (exists g r, In (q, g) (numbered p ps) /\ In r (kind_of hole g) /\ key r = k) \/ In (q, hole) (roles m k).
Proof.
  induction ps as [|x l IH]; intros p m; cbn [table_of numbered In].
  - split; [auto|]. intros [(g & r & [] & _)|H]; assumption.
  - rewrite IH, !add_roles_spec. split.
    + intros [(g & r & A & B & C)|[(E & r & B & C)|[(E & r & B & C)|H]]]; [| | |auto].
      * left. eauto 8.
      * injection E as -> ->. left. exists x, r. cbn [kind_of]. auto.
      * injection E as -> ->. left. exists x, r. cbn [kind_of]. auto.
    + intros [(g & r & [E|A] & B & C)|H]; [| |auto].
      * injection E as <- <-. destruct hole; cbn [kind_of] in B; right; [left|right; left]; eauto.
      * left. eauto 8.
Qed.

Lemma covered_spec ps w : good (table_of 1 ps (PM.empty _)) w ->
  is_covered w = existsb (fun g => existsb (fun r => has (key r) (odd w)) (outlines g)
    && negb (existsb (fun r => has (key r) (odd w)) (holes g))) ps.
Proof.
  intros [F P]. set (m := table_of 1 ps (PM.empty _)) in *.
  assert (R : forall q hole k, In (q, hole) (roles m k) <->
    exists g r, In (q, g) (numbered 1 ps) /\ In r (kind_of hole g) /\ key r = k).
  { intros q hole k. unfold m. rewrite table_of_spec. unfold roles at 1. rewrite PM.gempty. cbn [In]. tauto. }
  apply eq_true_iff_eq. unfold is_covered. rewrite negb_true_iff, not_empty_has, existsb_exists. split.
  - intros [p H]. rewrite (F p) in H. unfold is_cover in H. apply andb_prop in H. destruct H as [A B].
    apply negb_true_iff in A. apply not_empty_has in A. destruct A as [k A].
    apply (P p false k) in A. destruct A as [A A']. apply R in A'. destruct A' as (g & r & G & I & <-).
    exists g. split; [apply (numbered_all g ps 1); eauto|]. apply andb_true_intro. split.
    + apply existsb_exists. exists r. auto.
    + apply negb_true_iff, not_true_is_false. intros C. apply existsb_exists in C. destruct C as (s & S & C).
      assert (D : has (key s) (ones true (part p w)) = true).
      { apply P. split; [assumption|]. apply R. exists g, s. auto. }
      cbn [ones] in D. rewrite (proj1 (empty_has _) B) in D. discriminate.
  - intros (g & G & H). apply andb_prop in H. destruct H as [A B]. apply existsb_exists in A. destruct A as (r & I & A).
    apply (numbered_all g ps 1) in G. destruct G as [p G]. exists p. rewrite (F p). unfold is_cover.
    apply andb_true_intro. split.
    + apply negb_true_iff, not_empty_has. exists (key r). apply (P p false). split; [assumption|].
      apply R. exists g, r. auto.
    + apply empty_has. intros k. apply not_true_is_false. intros D. apply (P p true) in D. destruct D as [D D'].
      apply R in D'. destruct D' as (h & s & G' & S & <-). rewrite (numbered_once _ _ _ _ _ G' G) in S. cbn [kind_of] in S.
      apply negb_true_iff in B. assert (E : existsb (fun r => has (key r) (odd w)) (holes g) = true); [|congruence].
      apply existsb_exists. exists s. auto.
Qed.
