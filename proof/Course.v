(* What the checker knows after each record.

   The checker forgets points that are given and brought, and pieces of edges that are given and used. With each state of its own
   goes one that forgets nothing, in which the same triangles are laid. *)
Require Import ZArith List Lia Bool Permutation.
Require Import Sort Rings Check Place Laid.
Import ListNotations.
Open Scope Z_scope.

(* Two lists, and two shorter ones, from which some items of both are gone. *)
Definition shorter {A} (given used all_given all_used : list A) : Prop :=
  exists both, forall x, (In x all_given <-> In x given \/ In x both) /\ (In x all_used <-> In x used \/ In x both).

Lemma shorter_given {A} (n g u G U : list A) : shorter g u G U -> shorter (n ++ g) u (n ++ G) U.
Proof.
  intros [both B]. exists both. intros x. destruct (B x) as [L M]. split; [|exact M]. clear B M. rewrite !in_app_iff. tauto.
Qed.

Lemma shorter_used {A} (n g u G U : list A) : shorter g u G U -> shorter g (n ++ u) G (n ++ U).
Proof.
  intros [both B]. exists both. intros x. destruct (B x) as [L M]. split; [exact L|]. clear B L. rewrite !in_app_iff. tauto.
Qed.

Lemma shorter_same {A} (g u G H U : list A) : shorter g u G U -> (forall x, In x G <-> In x H) -> shorter g u H U.
Proof.
  intros [both B] E. exists both. intros x. destruct (B x) as [L M]. split; [|exact M]. rewrite <- E. exact L.
Qed.

Lemma shorter_cancel {A} compare (g u G U g' u' : list A) : (forall x y, compare x y = Eq -> x = y) ->
  shorter g u G U -> cancel compare g u = (g', u') -> shorter g' u' G U.
Proof.
  intros Eq [both B] C. destruct (cancel_in compare Eq _ _ _ _ C) as [more M]. exists (more ++ both). intros x.
  destruct (B x) as [L L']. destruct (M x) as [N N']. clear B M C Eq. rewrite in_app_iff. split; [clear L' N'|clear L N]; tauto.
Qed.

Lemma shorter_all {A} (g u G U : list A) : shorter g u G U -> (forall x, In x g <-> In x u) -> forall x, In x G <-> In x U.
Proof. intros [both B] E x. destruct (B x) as [L M]. rewrite L, M, E. reflexivity. Qed.

(* The states go on alike. *)
Definition like (s g : state) : Prop := passed s = passed g /\ ahead s = ahead g /\ rises s = rises g.

Lemma use_app m i l : use m i l = use m i [] ++ l.
Proof. unfold use. destruct m; reflexivity. Qed.

Lemma step_like rule judge t s s' g : step rule judge t s = Some s' -> like s g ->
  exists g' b v, step rule judge t g = Some g' /\ like s' g' /\
    brought s' = b ++ brought s /\ brought g' = b ++ brought g /\ used s' = v ++ used s /\ used g' = v ++ used g.
Proof.
  destruct s as [p h bs vs rs], g as [p' h' bg vg rg]. unfold like. cbn [passed ahead rises brought used]. intros S (<- & <- & <-).
  unfold step in *. cbn [passed ahead rises brought used] in *.
  destruct (Z.ltb 0 _); [|discriminate]. destruct (go _ p h) as [l [|i r]]; [discriminate|].
  destruct (same (corner_a t) _ && _ && _ && _); [|discriminate].
  destruct (before (corner_c t) (corner_b t)).
  - destruct (before (corner_a t) (corner_c t)); [|discriminate]. injection S as <-.
    eexists _, [corner_c t], (use (mark_ab (marks t)) i []). split; [reflexivity|]. cbn [passed ahead rises brought used].
    repeat (split; try reflexivity); apply use_app.
  - destruct r as [|j r]; [discriminate|].
    destruct (same (corner_b t) _ && _ && _); [|discriminate]. injection S as <-.
    eexists _, [], (use (mark_ab (marks t)) i (use (mark_bc (marks t)) j [])). split; [reflexivity|].
    cbn [passed ahead rises brought used]. repeat (split; try reflexivity);
      rewrite (use_app _ i (use _ j _)), (use_app _ j _), (use_app _ i (use _ j [])), app_assoc; reflexivity.
Qed.

Lemma lengthen_like x ends s f l s' g : lengthen x ends s = Some (f, l, s') -> like s g ->
  exists g' ps, adds x ps g g' /\ like s' g' /\ brought s' = ps ++ brought s /\ used s' = used s /\
    ((ends = None /\ f = x /\ l = x /\ ps = [left_end x; right_end x]) \/
     (exists f', ends = Some (f', l) /\ f = x /\ joins x f' = true /\ ps = [left_end x]) \/
     (exists l', ends = Some (f, l') /\ l = x /\ joins l' x = true /\ ps = [right_end x])).
Proof.
  destruct s as [p h bs vs rs], g as [p' h' bg vg rg]. unfold like. cbn [passed ahead rises brought used]. intros L (<- & <- & <-).
  unfold lengthen, adds, front in *. cbn [passed ahead rises brought used] in *.
  destruct (before (left_end x) (right_end x)); [|discriminate]. destruct ends as [[f' l']|].
  - destruct (joins x f') eqn:J; [|destruct (joins l' x) eqn:J'; [|discriminate]]; injection L as <- <- <-.
    + eexists (State _ _ (left_end x :: bg) vg rs), [left_end x]. cbn [passed ahead rises brought used].
      repeat split; [|right; left; exists f'; auto]. cbn [app]. rewrite rev_append_rev. constructor.
      apply Permutation_app_tail. symmetry. apply Permutation_rev.
    + eexists (State _ _ (right_end x :: bg) vg rs), [right_end x]. cbn [passed ahead rises brought used].
      repeat split; [|right; right; exists l'; auto]. rewrite rev_append_rev, <- Permutation_cons_append. constructor.
      rewrite Permutation_app_comm. apply Permutation_app_head. symmetry. apply Permutation_rev.
  - injection L as <- <- <-. eexists (State _ _ (left_end x :: right_end x :: bg) vg rs), [left_end x; right_end x].
    cbn [passed ahead rises brought used]. repeat split; [|left; auto]. symmetry. apply Permutation_middle.
Qed.

(* Lists of edges. *)
Lemma pieces_of_more b : forall through a acc l, pieces_of a through b acc = Some l ->
  exists n, l = n ++ acc /\ forall acc', pieces_of a through b acc' = Some (n ++ acc').
Proof.
  induction through as [|v r IH]; cbn; intros a acc l H.
  - injection H as <-. exists [piece a b]. auto.
  - destruct (inside a v b); [|discriminate]. apply IH in H. destruct H as (n & -> & N). exists (n ++ [piece a v]).
    split; [rewrite <- app_assoc; reflexivity|]. intros acc'. rewrite N, <- app_assoc. reflexivity.
Qed.

Lemma pieces_more : forall es acc l, pieces es acc = Some l ->
  exists n, l = n ++ acc /\ forall acc', pieces es acc' = Some (n ++ acc').
Proof.
  induction es as [|e r IH]; cbn; intros acc l H.
  - injection H as <-. exists []. auto.
  - destruct (same (edge_from e) (edge_to e)); [apply IH; assumption|].
    destruct (pieces_of _ _ _ acc) as [acc1|] eqn:P; [|discriminate].
    apply pieces_of_more in P. destruct P as (n & -> & N). apply IH in H. destruct H as (m & -> & M).
    exists (m ++ n). split; [rewrite <- app_assoc; reflexivity|]. intros acc'. rewrite N, M, <- app_assoc. reflexivity.
Qed.

Lemma pieces_app fs : forall es acc,
  pieces (es ++ fs) acc = match pieces es acc with Some acc' => pieces fs acc' | None => None end.
Proof.
  induction es as [|e r IH]; intros acc; [reflexivity|]. cbn [app pieces].
  destruct (same (edge_from e) (edge_to e)); [apply IH|]. destruct (pieces_of _ _ _ acc); [apply IH|reflexivity].
Qed.

Lemma falls_app ring_of fs : forall es acc, falls ring_of (es ++ fs) acc = falls ring_of fs (falls ring_of es acc).
Proof.
  induction es as [|e r IH]; intros acc; [reflexivity|]. cbn [app falls].
  destruct (ring_of e); [destruct (same (edge_from e) (edge_to e))|]; apply IH.
Qed.

Lemma falls_in_app d es fs : falls_in d (es ++ fs) [] = falls_in d fs (falls_in d es []).
Proof. destruct d; cbn [falls_in]; [reflexivity|apply falls_app..]. Qed.

Lemma ends_in_app d es fs : ends_in d (es ++ fs) [] = ends_in d fs (ends_in d es []).
Proof.
  destruct d; cbn [ends_in]; try reflexivity. generalize (@nil zrise). induction es as [|e r IH]; intros acc; [reflexivity|].
  cbn [app ends]. destruct (edge_ring e); apply IH.
Qed.

Definition line_of (ps : list zpoint) : line := fold_left (fun l p => see p l) ps NoPoint.

(* After the records rs: the sides of the lower hull, the state in which nothing is forgotten, and all pieces of edges. *)
Record knows (rule : bool) (d : zdomain) (judge : option table) (rs : list record) (c : course)
  (low_sides : list zside) (g : state) (ps : list zside) : Prop := {
  k_grown : grown rule judge low_sides (low c) (flat_map triangles_in rs) g;
  k_like : like (laying c) g;
  k_points : shorter (given c) (brought (laying c)) (flat_map points_in rs) (brought g);
  k_sides : shorter (split c) (used (laying c)) ps (used g);
  k_pieces : pieces (flat_map edges_in rs) [] = Some ps;
  k_fallen : fallen c = falls_in d (flat_map edges_in rs) [];
  k_open : open c = ends_in d (flat_map edges_in rs) [];
  k_line : seen_line c = line_of (flat_map points_in rs);
  k_empty : is_empty c = true <-> flat_map triangles_in rs = [];
  k_whole : judge <> None -> brought g = brought (laying c)
}.

Lemma start_knows rule d judge : knows rule d judge [] start [] (State [] [] [] [] []) [].
Proof.
  split; cbn; try reflexivity; try (exists []; cbn; tauto).
  - constructor.
  - repeat split.
  - destruct d; reflexivity.
  - destruct d; reflexivity.
  - split; reflexivity.
Qed.

Lemma take_knows rule d judge rs c low_sides g ps r c' : knows rule d judge rs c low_sides g ps ->
  take rule d judge r c = Some c' -> exists low_sides' g' ps', knows rule d judge (rs ++ [r]) c' low_sides' g' ps'.
Proof.
  intros [G L P S PS F O Li E W] T. destruct r as [p|e|x|t|]; cbn [take] in T.
  - injection T as <-. exists low_sides, g, ps.
    split; rewrite ?flat_map_app; cbn [flat_map points_in edges_in triangles_in app laying low given split fallen open seen_line
      is_empty]; rewrite ?app_nil_r; auto.
    + apply shorter_same with (p :: flat_map points_in rs).
      * apply (shorter_given [p]); assumption.
      * intros x. rewrite in_app_iff. cbn. tauto.
    + unfold line_of. rewrite fold_left_app, Li. reflexivity.
  - destruct (pieces [e] (split c)) as [q|] eqn:Q; [|discriminate]. injection T as <-.
    apply pieces_more in Q. destruct Q as (n & -> & N). exists low_sides, g, (n ++ ps).
    split; rewrite ?flat_map_app; cbn [flat_map points_in edges_in triangles_in app laying low given split fallen open seen_line
      is_empty]; rewrite ?app_nil_r; auto.
    + apply shorter_given. assumption.
    + rewrite pieces_app, PS. apply N.
    + rewrite falls_in_app, F. reflexivity.
    + rewrite ends_in_app, O. reflexivity.
  - destruct (lengthen x (low c) (laying c)) as [[[f l] s']|] eqn:Le; [|discriminate]. injection T as <-.
    apply (lengthen_like _ _ _ _ _ _ g) in Le; [|assumption]. destruct Le as (g' & added & A & L' & Br & Us & C).
    assert (K : forall low_sides', grown rule judge low_sides' (Some (f, l)) (flat_map triangles_in rs) g' ->
      exists low_sides' g' ps', knows rule d judge (rs ++ [NewLower x])
        (Course s' (Some (f, l)) (given c) (split c) (fallen c) (open c) (seen_line c) (is_empty c)) low_sides' g' ps').
    { intros low_sides' G'. destruct A as (_ & _ & Br' & Us' & _). exists low_sides', g', ps.
      split; rewrite ?flat_map_app; cbn [flat_map points_in edges_in triangles_in app laying low given split fallen open seen_line
        is_empty]; rewrite ?app_nil_r; auto.
      - rewrite Br, Br'. apply shorter_used. assumption.
      - rewrite Us, Us'. assumption.
      - intros J. rewrite Br, Br', (W J). reflexivity. }
    destruct C as [(E0 & -> & -> & ->)|[(f' & E0 & -> & J & ->)|(l' & E0 & -> & J & ->)]]; rewrite E0 in G.
    + apply (K [x]). pose proof (grown_ends rule judge _ _ _ _ G) as [_ ->]. apply grown_first with g; assumption.
    + apply (K (x :: low_sides)). apply grown_left with f' g; assumption.
    + apply (K (low_sides ++ [x])). apply grown_right with l' g; assumption.
  - destruct (step rule judge t (laying c)) as [s'|] eqn:St; [|discriminate]. injection T as <-.
    apply (step_like _ _ _ _ _ g) in St; [|assumption]. destruct St as (g' & b & v & St & L' & B1 & B2 & U1 & U2).
    exists low_sides, g', ps.
    split; rewrite ?flat_map_app; cbn [flat_map points_in edges_in triangles_in app laying low given split fallen open seen_line
      is_empty]; rewrite ?app_nil_r; auto.
    + apply grown_triangle with g; assumption.
    + rewrite B1, B2. apply shorter_used. assumption.
    + rewrite U1, U2. apply shorter_used. assumption.
    + split; [discriminate|]. intros Z. destruct (app_cons_not_nil _ _ _ (eq_sym Z)).
    + intros J. rewrite B1, B2, (W J). reflexivity.
  - exists low_sides, g, ps. destruct judge as [m|].
    + injection T as <-. split; rewrite ?flat_map_app; cbn [flat_map points_in edges_in triangles_in app]; rewrite ?app_nil_r; auto.
    + destruct (cancel compare_points _ _) as [g1 b1] eqn:C1. destruct (cancel compare_sides _ _) as [p1 u1] eqn:C2.
      injection T as <-.
      split; rewrite ?flat_map_app; cbn [flat_map points_in edges_in triangles_in app laying low given split fallen open seen_line
        is_empty passed ahead rises brought used]; rewrite ?app_nil_r; auto.
      * apply (shorter_cancel compare_points _ _ _ _ _ _ compare_points_eq P C1).
      * apply (shorter_cancel compare_sides _ _ _ _ _ _ compare_sides_eq S C2).
      * congruence.
Qed.

Lemma run_knows rule d judge : forall rs before_rs c low_sides g ps c', knows rule d judge before_rs c low_sides g ps ->
  run rule d judge rs c = Some c' -> exists low_sides' g' ps', knows rule d judge (before_rs ++ rs) c' low_sides' g' ps'.
Proof.
  induction rs as [|r rs IH]; cbn [run]; intros before_rs c low_sides g ps c' K H.
  - injection H as <-. rewrite app_nil_r. exists low_sides, g, ps. assumption.
  - destruct (take rule d judge r c) as [c1|] eqn:T; [|discriminate].
    apply (take_knows _ _ _ _ _ _ _ _ _ _ K) in T. destruct T as (l1 & g1 & p1 & K1).
    destruct (IH _ _ _ _ _ _ K1 H) as (l2 & g2 & p2 & K2). rewrite <- app_assoc in K2. exists l2, g2, p2. exact K2.
Qed.

(* The sides of the lower hull are a chain. *)
Fixpoint last_side (s : zside) (l : list zside) : zside := match l with [] => s | t :: r => last_side t r end.

Lemma last_side_end : forall l s, last_end s l = right_end (last_side s l).
Proof. induction l as [|t r IH]; intros s; [reflexivity|]. apply IH. Qed.

Lemma last_side_app x : forall l s, last_side s (l ++ [x]) = x.
Proof. induction l as [|t r IH]; intros s; [reflexivity|]. apply IH. Qed.

Lemma chain_app x : before (left_end x) (right_end x) = true ->
  forall l s, chain 1 s l = true -> joins (last_side s l) x = true -> chain 1 s (l ++ [x]) = true.
Proof.
  intros B. induction l as [|t r IH]; intros s C J; cbn [app last_side] in *.
  - apply andb_prop in J. destruct J as [E T]. cbn [chain] in *. apply andb_prop in C. destruct C as [-> _].
    rewrite E, B, Z.mul_1_l, T. reflexivity.
  - cbn [chain] in *. apply andb_prop in C. destruct C as [-> C]. apply andb_prop in C. destruct C as [C1 C].
    rewrite C1. apply (IH t C J).
Qed.

Lemma grown_chain rule judge low_sides ends ts s : grown rule judge low_sides ends ts s ->
  match ends with
  | None => low_sides = []
  | Some (f, l) => exists r, low_sides = f :: r /\ chain 1 f r = true /\ last_side f r = l
  end.
Proof.
  induction 1 as [| |ts s x s' G _ A|low_sides f l ts s x s' G IH J A|low_sides f l ts s x s' G IH J A]; auto.
  - destruct A as (B & _). exists []. cbn [chain last_side]. rewrite B. auto.
  - destruct A as (B & _). destruct IH as (r & -> & C & L). exists (f :: r). split; [reflexivity|]. split; [|exact L].
    apply andb_prop in J. destruct J as [E T]. cbn [chain] in *. rewrite B, E, Z.mul_1_l, T. exact C.
  - destruct A as (B & _). destruct IH as (r & -> & C & L). exists (r ++ [x]). split; [reflexivity|].
    split; [|apply last_side_app]. apply chain_app; try assumption. rewrite L. assumption.
Qed.

Lemma map_items_map {A} (f : item -> A) : forall l acc, map_items f l acc = rev (map f l) ++ acc.
Proof. induction l as [|i l IH]; intros acc; cbn; [reflexivity|]. rewrite IH, <- app_assoc. reflexivity. Qed.

Lemma marked_sides_more : forall l acc x, In x (marked_sides l acc) <-> In x (marked_sides l []) \/ In x acc.
Proof.
  induction l as [|i l IH]; cbn [marked_sides]; intros acc x; [cbn; tauto|].
  rewrite IH, (IH (use (marked i) i [])), (use_app _ i acc), in_app_iff. tauto.
Qed.

(* What the checker has looked at when it accepts triangles. *)
Record checked (rule : bool) (k : certificate) (low_sides : list zside) (f : zside) (r : list zside) (t : zside)
  (h : list zside) (g : state) (ps : list zside) (ends : option (zside * zside)) : Prop := {
  c_grown : grown rule (judge_of (domain k)) low_sides ends (triangles k) g;
  c_low : low_sides = f :: r;
  c_chain : chain 1 f r = true;
  c_high : map item_side (rev_append (passed g) (ahead g)) = t :: h;
  c_upper : chain (-1) t h = true;
  c_left : left_end f = left_end t;
  c_right : last_end f r = last_end t h;
  c_covered : all_covered (rev_append (passed g) (ahead g)) = true;
  c_pieces : pieces (edges k) [] = Some ps;
  c_points : forall p, In p (points k) <-> In p (brought g);
  c_sides : forall x, In x ps <-> In x (marked_sides (rev_append (passed g) (ahead g)) (used g));
  c_values : values_right (domain k)
    (rev_append (falls_in (domain k) (edges k) [])
      (last_rises (judge_of (domain k)) (rev_append (passed g) (ahead g)) (rises g)))
    (ends_in (domain k) (edges k) []) = true;
  c_once : judge_of (domain k) <> None -> NoDup (brought g)
}.

Lemma check_knows rule k : check rule k = true -> exists c low_sides g ps,
  knows rule (domain k) (judge_of (domain k)) (records k) c low_sides g ps /\ finish (domain k) (judge_of (domain k)) c = true.
Proof.
  unfold check. intros H. destruct (run rule _ _ (records k) start) as [c|] eqn:R; [|discriminate].
  apply (run_knows _ _ _ _ [] _ _ _ _ _ (start_knows _ _ _)) in R. destruct R as (l & g & ps & K).
  exists c, l, g, ps. auto.
Qed.

Theorem check_inv rule k : check rule k = true -> triangles k <> [] ->
  exists low_sides f r t h g ps ends, checked rule k low_sides f r t h g ps ends.
Proof.
  intros H N. apply check_knows in H. destruct H as (c & low_sides & g & ps & [G (Lp & La & Lr) P S PS F O _ E W] & Fin).
  unfold finish in Fin. destruct (is_empty c); [destruct (N (proj1 E eq_refl))|].
  rewrite Lp, La, Lr in Fin. destruct (low c) as [[f l]|]; [|discriminate].
  destruct (rev_append (map_items item_side _ []) []) as [|t h] eqn:High; [discriminate|].
  rewrite map_items_map, app_nil_r, rev_append_rev, app_nil_r, rev_involutive in High.
  repeat match goal with H : _ && _ = true |- _ => apply andb_prop in H; destruct H end.
  repeat match goal with H : same _ _ = true |- _ => apply same_eq in H end.
  pose proof (grown_chain _ _ _ _ _ _ G) as (r & Low & C & L).
  exists low_sides, f, r, t, h, g, ps, (Some (f, l)). split; try assumption.
  - rewrite last_side_end, L. assumption.
  - intros p. apply (shorter_all _ _ _ _ P). intros x.
    apply (same_set_once_in compare_points compare_points_eq). assumption.
  - destruct S as [both B]. intros x. destruct (B x) as [B1 B2].
    pose proof (same_set_in compare_sides compare_sides_eq _ _ ltac:(eassumption) x) as M.
    rewrite marked_sides_more in M. rewrite marked_sides_more, B1, B2, M. clear. tauto.
  - unfold edges. rewrite <- F, <- O. assumption.
  - intros J. rewrite (W J).
    apply (same_set_once_once compare_points compare_points_lt compare_points_same (given c)). assumption.
Qed.

Lemma check_empty rule k : check rule k = true -> triangles k = [] -> line_of (points k) <> OffLine.
Proof.
  intros H E. apply check_knows in H. destruct H as (c & low_sides & g & ps & K & Fin). intros L.
  unfold finish in Fin. rewrite (proj2 (k_empty _ _ _ _ _ _ _ _ K) E), (k_line _ _ _ _ _ _ _ _ K) in Fin.
  fold (points k) in Fin. rewrite L in Fin. discriminate.
Qed.
