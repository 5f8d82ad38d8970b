(* Merge sort and removal of equals, without recursion on the machine's stack.
   The proof needs one fact: nothing is lost and nothing is made. Order is not needed for the proof, only for finding
   equals. *)
Require Import List Permutation Wf_nat.
Import ListNotations.

Section Sort.
Context {A : Type} (compare : A -> A -> comparison).

(* Merging reverses: lists in order become one list in the opposite order. So the rounds take turns. *)
Definition goes_first (up : bool) (x y : A) : bool :=
  match compare x y with Lt => up | Eq => true | Gt => negb up end.

Lemma shorter_left {l1 l2 t : list A} {x : A} : l1 = x :: t -> length t + length l2 < length l1 + length l2.
Proof. intros ->. cbn. auto with arith. Qed.
Lemma shorter_right {l1 l2 t : list A} {y : A} : l2 = y :: t -> length l1 + length t < length l1 + length l2.
Proof. intros ->. cbn. rewrite <- plus_n_Sm. auto with arith. Qed.

Fixpoint merge (up : bool) (l1 l2 acc : list A) (H : Acc lt (length l1 + length l2)) {struct H} : list A :=
  match l1 as m1, l2 as m2 return l1 = m1 -> l2 = m2 -> list A with
  | [], _ => fun _ _ => rev_append l2 acc
  | _, [] => fun _ _ => rev_append l1 acc
  | x :: t1, y :: t2 => fun e1 e2 =>
    if goes_first up x y then merge up t1 l2 (x :: acc) (Acc_inv H (shorter_left e1))
    else merge up l1 t2 (y :: acc) (Acc_inv H (shorter_right e2))
  end eq_refl eq_refl.

Fixpoint merge_pairs (up : bool) (ls acc : list (list A)) : list (list A) :=
  match ls with
  | a :: b :: r => merge_pairs up r (merge up a b [] (lt_wf _) :: acc)
  | [a] => rev_append a [] :: acc
  | [] => acc
  end.

Fixpoint merge_all (rounds : nat) (up : bool) (ls : list (list A)) : list A :=
  match rounds, ls with
  | _, [] => []
  | _, [a] => if up then a else rev_append a []
  | O, a :: r => fold_left (fun acc l => rev_append l acc) r a
  | S n, _ => merge_all n (negb up) (merge_pairs up ls [])
  end.

Fixpoint singles (l : list A) (acc : list (list A)) : list (list A) :=
  match l with
  | [] => acc
  | x :: r => singles r ([x] :: acc)
  end.

(* Forty rounds are enough for 2^40 items. *)
Definition sort (l : list A) : list A := merge_all 40 true (singles l []).

Fixpoint distinct (l acc : list A) : list A :=
  match l with
  | [] => acc
  | x :: r =>
    match acc with
    | y :: _ => match compare x y with Eq => distinct r acc | _ => distinct r (x :: acc) end
    | [] => distinct r [x]
    end
  end.

Fixpoint equal (l m : list A) : bool :=
  match l, m with
  | [], [] => true
  | x :: l', y :: m' => match compare x y with Eq => equal l' m' | _ => false end
  | _, _ => false
  end.

Definition same_set (l m : list A) : bool := equal (distinct (sort l) []) (distinct (sort m) []).

(* The same, where the second list must have no item twice. *)
Fixpoint ascending (x : A) (l : list A) : bool :=
  match l with
  | [] => true
  | y :: r => match compare x y with Lt => ascending y r | _ => false end
  end.
Definition all_ascending (l : list A) : bool := match l with [] => true | x :: r => ascending x r end.
Definition same_set_once (l m : list A) : bool :=
  let o := sort m in all_ascending o && equal (distinct (sort l) []) (rev_append o []).

(* Takes off two lists what both have. Lists come from the last item to the first. *)
Fixpoint apart (l m left right : list A) : list A * list A :=
  match l with
  | [] => (left, rev_append m right)
  | x :: l' =>
    (fix beside (m right : list A) : list A * list A :=
      match m with
      | [] => (rev_append l left, right)
      | y :: m' =>
        match compare x y with
        | Eq => apart l' m' left right
        | Gt => apart l' m (x :: left) right
        | Lt => beside m' (y :: right)
        end
      end) m right
  end.
Definition cancel (l m : list A) : list A * list A := apart (distinct (sort l) []) (distinct (sort m) []) [] [].

Lemma merge_permutes up : forall n l1 l2 acc H, length l1 + length l2 <= n ->
  Permutation (merge up l1 l2 acc H) (acc ++ l1 ++ l2).
Proof.
  assert (R : forall l acc : list A, Permutation (rev_append l acc) (acc ++ l)).
  { intros l acc. rewrite rev_append_rev, <- Permutation_rev. apply Permutation_app_comm. }
  induction n as [|n IH]; intros l1 l2 acc [H] L; destruct l1 as [|x t1], l2 as [|y t2]; cbn [merge app];
    try (rewrite R, ?app_nil_r; reflexivity); [inversion L|].
  destruct (goes_first up x y).
  - rewrite IH by (cbn in *; apply le_S_n; assumption). cbn [app]. apply (Permutation_middle acc).
  - rewrite IH by (cbn in *; rewrite <- plus_n_Sm in L; apply le_S_n; assumption). cbn [app].
    rewrite (Permutation_middle acc). apply Permutation_app_head. apply (Permutation_middle (x :: t1)).
Qed.

Lemma merge_pairs_permutes up n : forall ls acc, length ls <= n ->
  Permutation (concat (merge_pairs up ls acc)) (concat acc ++ concat ls).
Proof.
  induction n as [|n IH]; intros ls acc H.
  - destruct ls; [|inversion H]. cbn. rewrite app_nil_r. reflexivity.
  - destruct ls as [|a [|b r]]; cbn [merge_pairs].
    + cbn. rewrite app_nil_r. reflexivity.
    + cbn. rewrite app_nil_r, rev_append_rev, app_nil_r, <- Permutation_rev. apply Permutation_app_comm.
    + rewrite IH by (cbn in H; apply le_S_n in H; apply le_S_n; apply le_S; assumption).
      cbn [concat]. rewrite (merge_permutes up _ a b [] _ (le_n _)). cbn [app].
      rewrite (Permutation_app_comm (a ++ b)), <- !app_assoc. reflexivity.
Qed.

Lemma merge_all_permutes n : forall up ls, Permutation (merge_all n up ls) (concat ls).
Proof.
  induction n as [|n IH]; intros up [|a [|b r]]; cbn [merge_all];
    try (destruct up; cbn; rewrite ?app_nil_r, ?rev_append_rev, ?app_nil_r, <- ?Permutation_rev; reflexivity).
  - assert (G : forall (r : list (list A)) a, Permutation (fold_left (fun acc l => rev_append l acc) r a) (a ++
      concat r)).
    { clear. induction r as [|l r IH]; intros a; cbn.
      - rewrite app_nil_r; reflexivity.
      - rewrite IH, rev_append_rev, <- Permutation_rev, app_assoc.
        apply Permutation_app_tail, Permutation_app_comm. }
    apply G.
  - rewrite IH, (merge_pairs_permutes up _ _ _ (le_n _)). reflexivity.
Qed.

Lemma singles_permutes l : forall acc, Permutation (concat (singles l acc)) (concat acc ++ l).
Proof.
  induction l as [|x r IH]; intros acc; cbn.
  - rewrite app_nil_r; reflexivity.
  - rewrite IH. cbn. apply Permutation_middle.
Qed.

Lemma sort_permutes l : Permutation (sort l) l.
Proof. unfold sort. rewrite merge_all_permutes, singles_permutes. reflexivity. Qed.

Lemma sort_in l x : In x (sort l) <-> In x l.
Proof.
  pose proof (sort_permutes l) as P. split; apply Permutation_in; [|symmetry]; assumption.
Qed.

Hypothesis compare_eq : forall x y, compare x y = Eq -> x = y.

Lemma distinct_in l : forall acc x, In x (distinct l acc) <-> In x acc \/ In x l.
Proof.
  induction l as [|a r IH]; intros acc x; cbn [distinct].
  - cbn; tauto.
  - destruct acc as [|y acc]; [rewrite IH; cbn; tauto|].
    destruct (compare a y) eqn:E; rewrite IH; cbn [In]; try tauto.
    apply compare_eq in E; subst; tauto.
Qed.

Lemma equal_eq l : forall m, equal l m = true -> l = m.
Proof.
  induction l as [|x l IH]; intros [|y m]; cbn; try easy.
  destruct (compare x y) eqn:E; try easy. intros H. apply compare_eq in E. f_equal; auto.
Qed.

Lemma same_set_in l m : same_set l m = true -> forall x, In x l <-> In x m.
Proof.
  intros H x. apply equal_eq in H.
  pose proof (distinct_in (sort l) [] x) as L. pose proof (distinct_in (sort m) [] x) as M.
  rewrite sort_in in L, M. rewrite H in L. cbn in L, M. tauto.
Qed.

Lemma same_set_once_in l m : same_set_once l m = true -> forall x, In x l <-> In x m.
Proof.
  intros H x. apply andb_prop in H. destruct H as [_ H]. apply equal_eq in H.
  pose proof (distinct_in (sort l) [] x) as L. rewrite H, rev_append_rev, app_nil_r, <- in_rev, !sort_in in L.
  cbn in L. tauto.
Qed.

Lemma apart_in : forall l m left right l' m', apart l m left right = (l', m') -> exists both, forall x,
  (In x l \/ In x left <-> In x l' \/ In x both) /\ (In x m \/ In x right <-> In x m' \/ In x both).
Proof.
  assert (R : forall (l acc : list A) x, In x (rev_append l acc) <-> In x l \/ In x acc).
  { intros l acc x. rewrite rev_append_rev, in_app_iff, <- in_rev. reflexivity. }
  induction l as [|x l IH]; intros m left right l' m'.
  - cbn. intros H. injection H as <- <-. exists []. intros y. rewrite R. cbn. tauto.
  - revert right. induction m as [|y m IM]; intros right; cbn [apart].
    + intros H. injection H as <- <-. exists []. intros z. rewrite R. cbn. tauto.
    + destruct (compare x y) eqn:C; intros H.
      * apply compare_eq in C. subst y. destruct (IH _ _ _ _ _ H) as [both B]. exists (x :: both). intros z.
        destruct (B z) as [L M]. clear IH IM B. cbn [In]. split; [clear M|clear L]; tauto.
      * destruct (IM _ H) as [both B]. exists both. intros z. destruct (B z) as [L M]. clear IH IM B.
        split; [exact L|clear L]. cbn [In] in *. tauto.
      * destruct (IH _ _ _ _ _ H) as [both B]. exists both. intros z. destruct (B z) as [L M]. clear IH IM B.
        split; [clear M|exact M]. cbn [In] in *. tauto.
Qed.

Lemma cancel_in l m l' m' : cancel l m = (l', m') -> exists both, forall x,
  (In x l <-> In x l' \/ In x both) /\ (In x m <-> In x m' \/ In x both).
Proof.
  intros H. destruct (apart_in _ _ _ _ _ _ H) as [both B]. exists both. intros x. destruct (B x) as [L M].
  rewrite distinct_in, sort_in in L, M. cbn [In] in L, M. clear B H. split; [clear M|clear L]; tauto.
Qed.

Hypothesis compare_lt : forall x y z, compare x y = Lt -> compare y z = Lt -> compare x z = Lt.
Hypothesis compare_same : forall x, compare x x <> Lt.

Lemma ascending_after : forall l x, ascending x l = true -> forall y, In y l -> compare x y = Lt.
Proof.
  induction l as [|z l IH]; cbn; intros x H y I; [destruct I|].
  destruct (compare x z) eqn:E; try discriminate. destruct I as [<-|I]; [assumption|].
  apply compare_lt with z; [assumption|]. apply IH; assumption.
Qed.

Lemma ascending_once : forall l x, ascending x l = true -> NoDup (x :: l).
Proof.
  induction l as [|y l IH]; intros x H; apply NoDup_cons.
  - intros [].
  - constructor.
  - intros I. pose proof (ascending_after _ _ H x I) as L. destruct (compare_same _ L).
  - cbn in H. destruct (compare x y); try discriminate. apply IH. assumption.
Qed.

Lemma same_set_once_once l m : same_set_once l m = true -> NoDup m.
Proof.
  intros H. apply andb_prop in H. destruct H as [H _].
  apply Permutation_NoDup with (sort m); [apply sort_permutes|].
  destruct (sort m) as [|x r]; [constructor|]. apply ascending_once. assumption.
Qed.
End Sort.
