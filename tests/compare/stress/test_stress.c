/* The judge of `stress`: cases that once broke a bound keep it now, and it sees what is wrong. */
#include <float.h>

#include "tests/support/agree.h"

#define QUADRATIC &scallop_gait_quadratic
#define SINUSOIDAL &scallop_gait_sinusoidal
#define DEGREE_15 "polynomial:0,0,0,0,0,0,0,6435,-40040,108108,-163800,150150,-83160,25740,-3432"
#define DEGREE_16 "polynomial:0,0,0,0,0,0,0,0,0,0,0,0,0,0,16,-15"

/* Every one broke a bound at the time; the comment says which. m1, m2, F1, F2, L, T, alpha; of a phase v0
 * in front of them */
#define STEADY(gait, ...) \
  { \
    gait, \
    { \
      .motion = { OF_STEADY, { __VA_ARGS__, NULL } } \
    } \
  }
#define PHASE(gait, of, start, ...) \
  { \
    gait, \
    { \
      .motion = { OF_PHASE, { __VA_ARGS__, NULL }, of, (start) } \
    } \
  }
#define EXTENSION(gait, ...) PHASE(gait, SCALLOP_EXTENSION, __VA_ARGS__)
#define CONTRACTION(gait, ...) PHASE(gait, SCALLOP_CONTRACTION, __VA_ARGS__)
static const struct {
  const char *gait;
  struct stress_case stressed;
} past[] = {
  /* displacements by cancellation: off by 3e9 units, wrong sign, 1e-8 of it */
  STEADY("quadratic", 0.00052487381692070179, 147.97618149855299, 98372.915619602267, 1.787794455676155e-06,
         0.27149485564844894, 16686420.713431345, 2.4221762714553326e-09),
  STEADY("quadratic", 0.33196971906351996, 0.44297072310576879, 817077.70466290112, 1.6646741623536634,
         0.77906597518635945, 0.002599579705946136, 0.49999926488119784),
  STEADY("sinusoidal", 0.071729754868401149, 4330.9711771055063, 993965.36657233128, 36.688541597422223,
         2.9310419353539467, 0.9294187699687888, 0.72988877663336404),
  STEADY("sinusoidal", 977.73893400245606, 977.73893400245606, 12137.090935140261, 5.8565067475741297e-06,
         12.093461985590215, 68.92507819911674, 0.03181171484790106),
  /* nearly equal phases in stick-slip: 40, 23 and 108 units */
  STEADY("quadratic", 5.148124108194392, 7.0132926744239334, 5.729352761734194, 0.4991015302432081, 0.536232152736577,
         2.272541868390904, 0.5000699782488248),
  STEADY("quadratic", 0.9926708252741789, 1.0140939995693419, 3.4935085702507123, 0.38451001095873316,
         0.1194013125549291, 0.521289558824811, 0.4999999999999987),
  STEADY("quadratic", 0.2657906095207949, 1.8443521145828936, 0.6766610650811689, 3.1406318191960025,
         0.3792819943479877, 0.47798244891682434, 0.5000000000000576),
  /* a small displacement of a body that hardly moves, on curves: 9.7 units */
  STEADY("sinusoidal", 0.10411340053309306, 3.3508146153665646, 26624.106549212145, 2.988670220854292e-05,
         0.39458824015341476, 0.0719487798413758, 0.1433798059821129),
  /* equal forces: the certified multiplier was that of a start from rest, not that from the right */
  STEADY("quadratic", 0.14791490392001166, 4.153161001266711, 4.98309005623809, 4.98309005623809, 1.5125159656102465,
         0.6962170114413387, 0.13448032945394514),
  STEADY("quadratic", 0.22972877563251805, 0.19509842673532038, 0.11399183267423342, 0.11399183267423342,
         2.996228754741229, 0.00490124870869504, 0.48698032945394515),
  STEADY("quadratic", 4, 4, 8, 8, 0.078125, 4, 0.125),
  /* small and delicate multipliers: 7, 10 and 14.7 units */
  STEADY("quadratic", 12989.265806967274, 6.838947557049164e-05, 0.21610965186188144, 0.233506094676906,
         0.5726882487269702, 270.81904921014456, 0.23311388686299322),
  STEADY("sinusoidal", 0.6916941098270002, 8.090818874469255, 7.79998703893075, 1.0182711942697604, 1.169576489829463,
         0.32620065650653446, 0.1439625764602608),
  STEADY("sinusoidal", 0.1431428755741435, 1.9360748204155929, 0.7311225433065942, 0.10130658690765737,
         0.9944699446935663, 0.09540978464105478, 0.6157183640450239),
  /* v_start as the root of a balance where the map knows it better: 14.5 units; 151 over the rounding modes */
  STEADY("quadratic", 0.23409219040837323, 9.546211733531907, 0.3651937318430305, 0.260345706882307, 3.655638238351494,
         6.494242351737075, 0.6492413465678691),
  STEADY("sinusoidal", 5.883036967984184, 0.3008188030817918, 1.4639673163467202, 4.532115385323999, 7.459610125069946,
         3.867844052921239, 0.6486735723966093),
  /* roots near a graze: 168 and 5450 units; a curve met again within rounding of where it was left: 2e5 and 2e5 */
  CONTRACTION("sinusoidal", -5.719741168548959, 0.7379235621757413, 0.17279133088169912, 2.8769847370370223,
              8.152861036147794, 0.2558007940367523, 0.02295220814304512, 0.4108286141604185),
  CONTRACTION("sinusoidal", -6.994972966935122, 5.3141431951569045, 7.587523945718456, 0.1084200074732264,
              5.270561859541146, 2.616179349263198, 0.3771565982911961, 0.0742661141604185),
  CONTRACTION("sinusoidal", 0.03929984063160954, 0.13122342767996978, 9.716770598941878, 0.5116082720869182,
              0.4584690679160113, 0.14384735750337083, 0.6485428601002985, 0.050828614160418506),
  CONTRACTION("sinusoidal", 0.31998615309617356, 0.15532936444050557, 2.8274122624093954, 0.15225458167597986,
              0.16041883291720638, 2.586930139922762, 12.125750668505942, 0.5041098641604185),
  /* the wider solver stepped past a root at 1e-126 and at 1e-129 */
  EXTENSION("sinusoidal", 0, 0.11380195406436137, 3.615307102030025, 0.45641522623489855, 0.11049130657499823,
            0.832118811492328, 1.1792070193682409e-63, 0.4781556418538094),
  EXTENSION("sinusoidal", 2.471788425754976e-136, 2.4172607583507512e+83, 3.307182283592683e+82,
            4.5035833165008955e+207, 7.459466995459556e+207, 6.159513514177499e-140, 3.736632605264595e-132,
            0.7662163624167442),
  /* at two boundaries at once, or within an ulp of one: 73 and 3e4 units, modes of the other side, estimates of 0.999
   * and 145 times the error */
  STEADY("quadratic", 0.37301750198007094, 0.44160354787095235, 20.8785681401368, 20.846064381672328, 8.56075527922853,
         43.138547532628984, 0.49999999999999994),
  EXTENSION("sinusoidal", 0.841667910543947, 7, 7, 7, 1.462512274682653, 2, 3.9182544528463374, 0.75),
  EXTENSION("sinusoidal", -2.0034003880955673, 0.23528920847728652, 0.17956994777613614, 0.2696361677614749,
            0.4828673772098576, 2.152789910113694, 5.175894786611206, 0.5111794754445868),
  EXTENSION("sinusoidal", 0.037290210876947096, 5, 5, 5, 0.8004515067598551, 1.1074766642383633, 5.0990195135927845,
            0.5),
  STEADY("quadratic", 0.8716085590137637, 0.16942212265890932, 0.0710248564013969, 1.210745917262718,
         0.7175627278143986, 0.08252046013678406, 0.5005363891853923),
  STEADY("quadratic", 0.7566144623522062, 3737.709958927785, 5.7488033749985e-10, 2.2409790576993287,
         0.3189125814255519, 0.13172655001017952, 0.505140103362899),
  STEADY("sinusoidal", 0.6844796574313278, 12907.150034064034, 4.17694828181972, 0.1466324045231615, 0.5266207490930883,
         1.332688839065015, 0.5175821637508544),
  STEADY("sinusoidal", 4.473944513255902, 54.693408092858036, 1.4462717795882048e-09, 3.7942775617030597,
         3.267268835748595, 2.8397833843086433, 0.42908320802576255),
  EXTENSION("sinusoidal", 1.246571137142524e-14, 3.000000000000518, 4.076348673482061, 4, 4.000000000000082, 5, 2, 0.5),
  STEADY("quadratic", 1.0993368982127625, 0.002780394547765512, 0.11211957425379535, 0.11212031138168456,
         5.776636284015704, 13.145026964763188, 0.8096829554026446),
  EXTENSION("sinusoidal", 10.761636253131835, 0.39162114865926145, 0.0343089971422144, 39.7908351732154,
            4.209761269513402, 0.6657875917813478, 0.20834741657763867, 0.5),
  EXTENSION("sinusoidal", 0, 1.951206793619086, 1.9512067936190862, 27.6217347947801, 27.621734794780096,
            1.5672655386774725, 0.01959038408093995, 1.0921051142636284e-06),
  EXTENSION("sinusoidal", -0.001556463804267371, 0.136147018432814, 180.33027449787497, 0.17985188490807028,
            0.17985188490807047, 0.4875424041911838, 57.15946626700791, 0.01669492529513949),
  STEADY("sinusoidal", 0.3523853690342964, 94643.43924995365, 930844.6022886682, 1.5020551975378542,
         0.18667932792046993, 1.2241932919676026, 0.25),
  EXTENSION("quadratic", -2.954694849287062, 7, 4.048747544066337, 7, 1.000000000128914, 8, 1, 0.375),
  /* v_start improved across 0, with the modes and the multiplier of the other side */
  STEADY("sinusoidal", 1, 1, 4, 1, 10, 2.9447531087543193, 0.75),
  STEADY("sinusoidal", 1, 1, 4, 1, 10, 2.9447531087543197, 0.75),
  /* a body released just before l'' is steepest, and caught again soon after: 3e3, 1.4e4 and 1.9e4 units */
  EXTENSION("minimum-jerk", 0, 1, 1, 4, 1, 10, 6.796176979, 0.5),
  EXTENSION("minimum-jerk", 0, 0.13910231149513322, 3.748789126195413, 1.1661362945750007, 6.323069286997304,
            0.4836016194920944, 0.3663211709658381, 0.7491572211682797),
  EXTENSION("polynomial:0,0,0,35,-84,70,-20", 0, 4.949684433193895, 4.688232166454887, 0.49789904838967836,
            0.33358295082521355, 0.13664896867022633, 18.345320823198815, 0.29502207070589065),
  /* released early, and caught near the end: 2e5 units if counted from the release all the way */
  CONTRACTION("minimum-jerk", 0, 0.5469405679464527, 0.22888580001547107, 0.18529457151913437, 5.00622364346652,
              3.2583611146692975, 0.0103, 0.259),
  /* a root that Newton's steps did not get to, and crossed with the last of them: 4e9 units */
  CONTRACTION("polynomial:0,0,0,35,-84,70,-20", -1.2813210988875906e-06, 0.39103649769416415, 0.2860229981068453,
              4.520768495446121, 4.352551746705724, 1.2148938382464751, 0.001787415058391338, 0.053628653958439826),
  /* l'' goes with t^2 and the body leaves rest at 1e-97 of the phase, where the search for it did not get to: 1e15
   * units */
  CONTRACTION("polynomial:0,0,0,35,-84,70,-20", 0, 1.0038726027937885, 2.7234725458171587, 0.22941104443983673,
              0.4614474148894865, 0.4486942986572502, 1.5717202005720724e-97, 0.3099920505285263),
  /* its body leaves rest just before l'' is steepest: 37 units over the rounding modes with a search that takes the
   * wrong end */
  EXTENSION("polynomial:0,0,0,35,-84,70,-20", 0, 0.2796751659140918, 0.4276855676947472, 0.2111825647632437,
            0.1500468544162752, 0.3328990436695564, 4.494756589609767, 0.930630007609725),
  /* near the peak of an l' that begins level: a multiplier off by 9.8 units */
  STEADY("minimum-jerk", 122.30902282832216, 0.3908810071319938, 0.33535644707960144, 1.2633472626982118,
         0.5426268871333776, 0.041958233201500085, 0.6585379809141159),
  /* displacements that were the sum of many parts: 34, 33, 37 and 32.2 units over the rounding modes */
  STEADY("trapezoidal:0.2,0.3", 4.2897213917733685, 0.33806363175756327, 0.03381712873874502, 49.1425168193602,
         0.725468536704967, 4.290749101059595, 0.09786531761288643),
  STEADY("trapezoidal:0.2,0.3", 0.2669158716769277, 0.4790332291416791, 67443.70472243283, 7.28376344028617e-06,
         0.13646857116940045, 0.025205494005986807, 0.057084067612886424),
  STEADY("trapezoidal:0.2,0.3", 0.35136553894421135, 0.9798433642799811, 0.00046407471079640126, 6191.547254502185,
         0.11152857676237504, 0.11324356450661112, 0.03470125511288643),
  STEADY("trapezoidal:0.2,0.3", 0.5136256064499766, 0.13015864570088923, 1.6068564878702802e-06, 201107.95233913255,
         3.289933061773951, 11.802600654725403, 0.0004246258378585346),
  /* a body turns on the plateau of l', or beside it, as the last digit of v_start would have it: multipliers off by up
   * to 1e16 units */
  STEADY("trapezoidal:0.2,0.3", 1.0876132763364066, 0.13878850210338436, 0.20962871120956791, 1.028428347880501,
         0.12311408808946879, 5.610482151080798e-25, 0.685939000621438),
  STEADY("trapezoidal:0.2,0.3", 0.15307772538227646, 1.4130775237124829, 7.252926297928954, 0.7306956790233666,
         0.16124834007204358, 4.051438546307467e-13, 0.5771890006214381),
  STEADY("trapezoidal:0.2,0.3", 3.989584108552207, 0.16244743696467295, 0.34846076787948876, 9.787903166518282,
         0.11823052759640278, 3.2269228611818707e-57, 0.478751500621438),
  STEADY("trapezoidal:0.2,0.3", 9.264266863572564, 0.20477245590437596, 4.805339499068493, 8.02834330740338,
         0.29759796335198935, 8.812892807786332e-84, 0.7935306211560964),
  STEADY("trapezoidal:0.2,0.3", 5.573242390328029, 0.5241730207049273, 0.35873268753011817, 8.285101064872345,
         0.92847578089032, 1.214522851181419e-47, 0.8994681211560964),
  /* displacements that are exactly 0, in units of 1e-118; where wider arithmetic gave way to what rounding leaves;
   * below all doubles */
  STEADY("constant:0", 1.5799049481049328e-19, 8.007708909753664e-19, 3.3818425441802536e+49, 5.217430166161229e+50,
         4.463649509681763e-118, 4.850828916667335e-93, 0.37747005686163904),
  STEADY("constant:0", 54586547628.24291, 209953909841.15845, 1.8381393947663727e-45, 3.915262830645332e-44,
         3.5114993040581024e+46, 1.2433951083329607e+142, 0.4932892878353596),
  STEADY("constant:0", 3.2198643895815924e-289, 2.3191928170937033e-290, 1.1599179546097464e+134,
         4.753236649705208e+134, 2.7128890948367915e-114, 1.6555277408431848e-120, 0.5723908503353595),
  /* within rounding of an interval of steady states: a multiplier of 1 beside the kink that the root is on; a body that
   * is held for no time */
  STEADY("constant:0", 3.4635466674960482, 1.0688418291279091, 5.971617590525057, 5.9716175905250894, 9.741636702389892,
         0.0023399875593768426, 0.7316231469810008),
  STEADY("constant:0", 6.731242897653908, 0.11243100631258374, 0.9247692809973254, 0.9247692809973371,
         2.419086849157373, 0.003259218739296325, 0.9751387719810009),
  STEADY("constant:0", 0.27993230990107, 0.5125241279515904, 9.535410230707512, 2.187912011127536, 0.3332033280764071,
         0.06225639253066868, 0.3852743637561798),
  /* l'' rises with a high power of t: the time at which friction lets go of a body was wrong by 2e7 to 3e15 units */
  STEADY(DEGREE_15, 0.23102255964835983, 0.10762550269443556, 0.19701799840672077, 0.19865749820029308,
         1.5009157925691794, 503.80552025040816, 1.0535657289685322e-17),
  CONTRACTION(DEGREE_15, 0, 3.7915156340119136, 1.21435163409014, 0.9971883216181356, 0.18104305762674744,
              0.1482320960466891, 2.847321759988126e-48, 0.838513874784112),
  EXTENSION(DEGREE_16, 0, 0.4596843333758352, 0.920657820830518, 1.7433424061510152, 2.6577417509821517,
            0.2741505137192422, 2.262414473220383e-81, 0.6921631495654583),
  EXTENSION("polynomial:0,0,0,0,0,0,8,-7", 0, 1, 1, 4, 1, 10, 1e-14, 0.75),
  EXTENSION("polynomial:0,0,0,5,-4", 0, 1, 1, 4, 1, 10, 1e-45, 0.75),
  STEADY("polynomial:0,0,0,5,-4", 1, 1, 4, 1, 10, 1, 1e-16),
  STEADY("polynomial:0,0,0,0,0,0,8,-7", 1, 1, 4, 1, 10, 1, 1e-40),
  /* rounding of times magnified in the velocity: 46 and 91 units over the rounding modes */
  STEADY(DEGREE_16, 311.0858670126067, 1085.2359192975543, 8261931.5159621285, 0.004511162376799768,
         9.050755238888156e-08, 2.752754432308982e-11, 1.7606567857767783e-07),
  STEADY(DEGREE_16, 3.110858670126067e-05, 1085235.9192975543, 826193.1515962129, 451.11623767997673,
         0.9050755238888156, 8.704973845220184e-07, 1.33944444321873e-12),
  /* friction moves c along a plateau by less than an ulp though it does much in a period: multipliers of 1 or of 4e-11
   * with the rounding mode; only the second phase begins on a plateau; the level is no good base where c goes far from
   * it */
  STEADY("constant:1e-30", 2.5777731237031962, 0.13952214522694503, 0.4207095818940854, 0.42070958189409136,
         8.84295043062907, 0.004311447654293054, 0.457176218777895),
  STEADY("constant:1e-30", 0.7553570696450808, 0.5944966992462923, 3.372503057195807, 3.372503057492215,
         0.34282045875183653, 0.7144454203444447, 0.5000000000000647),
  STEADY("constant:1e-22", 5.006565277816992, 4.169129778007256, 0.19891456859668977, 0.6327844135567791,
         9.186860339288453, 0.5035157571464632, 0.5000000000000023),
  STEADY("constant:1e-30", 0.19420265730223488, 5.103352388310775, 0.7770793771728096, 0.903219077980574,
         4.197851447048273, 12008.486149002609, 0.986654625752944),
};

static struct stress_case judged(const struct stress_case *made)
{
  struct stress_case stressed = *made;
  stress_judge(&stressed);
  return stressed;
}

static void check_bounds(const struct stress_case *c)
{
  enum stress_outcome outcome = bound_is_kept(&c->motion, 0, false);
  assert_true(outcome == STRESS_SOLVED || outcome == STRESS_UNDECIDED);
}

TEST(past_failures)
{
  const long count = sizeof past / sizeof *past, step = count / check_cases(count);
  for (long i = 0; i < count; i += step) {
    struct stress_case c = past[i].stressed;
    c.motion.crawler.gait = gait_of_text(past[i].gait).gait;
    check_bounds(&c);
  }
}

/* The velocity is that of a plateau, or of both where alpha is m2/M, and friction does next to nothing in a period: it
 * slides or is held there. */
TEST(on_a_plateau)
{
  static const char *const gaits[] = { "trapezoidal:0.0625,0.03125", "trapezoidal:0.1,0.1", "trapezoidal:0.03125,0.125",
                                       "trapezoidal:0.2,0.3" };
  struct random r = { 20261122 };
  int held = 0, turned = 0;
  for (int i = 0; i < 60; i++) {
    struct stress_case s = { .motion.crawler = { .m1 = random_decades(&r, 0.03, 30),
                                                 .m2 = 1,
                                                 .F1 = random_decades(&r, 0.1, 10),
                                                 .F2 = 1,
                                                 .L = random_decades(&r, 0.1, 10),
                                                 .alpha = random_between(&r, 0.05, 0.95),
                                                 .gait = gait_of_text(gaits[i % 4]).gait } };
    if (i % 3 == 0) {
      s.motion.crawler.m1 = 1 + random_below(&r, 15);
      s.motion.crawler.m2 = 16 - s.motion.crawler.m1;
      s.motion.crawler.alpha = s.motion.crawler.m2 / 16;
    }
    s.motion.crawler.T = random_decades(&r, 1e-90, 1e-4);
    check_bounds(&s);
    struct scallop_steady_result result = steady_of(&s.motion.crawler);
    held += result.period.regime == SCALLOP_STICK_SLIP;
    turned += result.period.multiplier > 0 && result.period.multiplier < 0.99;
  }
  assert_true(held >= 10 && turned >= 2);
}

/* Below 1e-289 of L/tau of the shorter phase, the extension here, digits of v_mid may be lost; above they may not. */
TEST(units_far_below_the_natural_one)
{
  const struct stress_case lost = { .motion.crawler = { 80, 40, 6, 1.8, 10, 12000, 1e-152, SINUSOIDAL } };
  const struct stress_case kept = { .motion.crawler = { 80, 40, 6, 1.8, 10, 12000, 1e-130, SINUSOIDAL } };
  struct stress_case j;
  check_bounds(&lost);
  check_bounds(&kept);
  j = judged(&lost);
  assert_true(isnan(j.number[Q_V_MID].ulp) && j.number[Q_V_MID].error > 0);
  j = judged(&kept);
  assert_true(j.number[Q_V_MID].ulp > 0);
}

/* What over- or underflows is refused, and nothing else is. */
TEST(refusals)
{
  static const struct stress_case refused[] = {
    { .motion.crawler = { 1, 1, 4, 1, 1e-300, 1e10, 0.75, QUADRATIC } },                        /* L/T underflows */
    { .motion.crawler = { 1, 1, 4e300, 1e300, 1e-5, 1e3, 0.75, QUADRATIC } },                   /* eps overflows */
    { .motion.crawler = { 80, 40, 6, 1.8, 10, 12000, 1e-156, SINUSOIDAL } },                    /* alpha^2 underflows */
    { .motion = { .of = OF_PHASE, .crawler = { 1, 1, 4, 1, 1e300, 1e-10, 0.75, QUADRATIC } } }, /* L/tau overflows */
  };
  for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
    struct stress_case j;
    j = judged(&refused[i]);
    assert_int_equal(j.outcome, STRESS_REFUSED);
    for (int q = 0; q < QUANTITIES; q++)
      assert_true(!j.number[q].judged && !j.number[q].broken);
  }
}

/* The condition number of something simple: froude = M L / (T^2 (F1 + F2)) has sum |x_i d ln y/d x_i| = 1 + 1 + 2 + 1 =
 * 5, and v_end = v0 - eps L/tau of a phase that is all braking is known. */
TEST(condition_numbers)
{
  struct stress_case c = { .motion.crawler = { 1.37, 0.85, 3.9, 1.21, 9.3, 0.71, 0.63, SINUSOIDAL } };
  struct stress_case j;
  j = judged(&c);
  assert_int_equal(j.outcome, STRESS_SOLVED);
  double condition = j.number[Q_FROUDE].unit
                     / j.number[Q_FROUDE].ulp; /* ulps of parameters and of the result are 1 to 2 roundings each */
  assert_true(condition > 2.5 && condition < 10);
  CHECK_AT_MOST(j.number[Q_FROUDE].error, 2 * j.number[Q_FROUDE].ulp);
}

/* Each broken bound is reported. */
TEST(sees_what_is_wrong)
{
  struct stress_case c = { .motion.crawler = { 1.37, 0.85, 3.9, 1.21, 9.3, 0.71, 0.63, QUADRATIC } };
  struct stress_case right, j;
  right = judged(&c);
  for (int q = Q_FROUDE; q <= Q_MULTIPLIER; q++)
    assert_true(right.number[q].judged && !right.number[q].broken && !stress_broken(&right.number[q]));
  j = right;
  j.number[Q_V_START].error = 8.01 * j.number[Q_V_START].unit;
  j.number[Q_V_START].estimate = j.number[Q_V_START].error;
  assert_string_equal(stress_broken(&j.number[Q_V_START]), "error");
  const struct {
    int number;
    double *changed, value;
    const char *says;
  } broken[] = {
    { Q_V_MID, &j.number[Q_V_MID].error, NAN, "error" },
    { Q_DISPLACEMENT, &j.number[Q_DISPLACEMENT].rounding, 32.1 * right.number[Q_DISPLACEMENT].unit,
      "spread over the rounding modes" },
    { Q_DISPLACEMENT, &j.number[Q_DISPLACEMENT].perturbed, 17.1 * right.number[Q_DISPLACEMENT].unit,
      "spread over parameters an ulp apart" },
    { Q_MEAN_VELOCITY, &j.number[Q_MEAN_VELOCITY].estimate, 0.99 * right.number[Q_MEAN_VELOCITY].error,
      "estimate of the error too small" },
    { Q_MEAN_VELOCITY, &j.number[Q_MEAN_VELOCITY].estimate, 200 * right.number[Q_MEAN_VELOCITY].ulp,
      "estimate of the error too large" },
  };
  for (size_t i = 0; i < sizeof broken / sizeof *broken; i++) {
    j = right;
    *broken[i].changed = broken[i].value;
    assert_string_equal(stress_broken(&j.number[broken[i].number]), broken[i].says);
  }
  j.number[Q_FROUDE] = right.number[Q_FROUDE];
  j.number[Q_FROUDE].rounding = NAN; /* of a trajectory there is but the error */
  assert_null(stress_broken(&j.number[Q_FROUDE]));
  c.motion.crawler.T = -1; /* and a case may be broken as a whole */
  j = judged(&c);
  assert_int_equal(j.outcome, STRESS_BROKEN);
  for (int q = 0; q < QUANTITIES; q++) {
    assert_string_equal(j.number[q].broken, scallop_status_text(SCALLOP_EDOMAIN));
    assert_false(j.number[q].judged);
  }
}

static bool same_cases(const struct stress_case *a, const struct stress_case *b, int count)
{
  char text[2][STRESS_ARGUMENTS];
  bool same = true;
  for (int i = 0; same && i < count; i++) {
    stress_arguments(&a[i], text[0]);
    stress_arguments(&b[i], text[1]);
    same = a[i].motion.of == b[i].motion.of && strcmp(text[0], text[1]) == 0;
  }
  return same;
}

/* Same seed, same cases; another one, others. Families make what they say. */
TEST(families)
{
  enum { COUNT = 40 };
  struct stress_case a[COUNT], b[COUNT], other[COUNT];
  int n = 0;
  for (const struct stress_family *f = stress_families; f->name; f++, n++) {
    int made = stress_make(f, SINUSOIDAL, 1, COUNT, a);
    assert_int_equal(made, COUNT);
    assert_int_equal(stress_make(f, SINUSOIDAL, 1, COUNT, b), COUNT);
    assert_int_equal(stress_make(f, SINUSOIDAL, 2, COUNT, other), COUNT);
    assert_true(same_cases(a, b, COUNT));
    assert_false(same_cases(a, other, COUNT));
    for (int i = 0; i < COUNT; i++) {
      assert_int_equal(a[i].motion.of, f->kind == STRESS_STEADY ? OF_STEADY : OF_PHASE);
      assert_int_equal(a[i].periods > 0, f->kind == STRESS_TRAJECTORY);
      assert_int_equal(scallop_crawler_check(&a[i].motion.crawler, NULL), SCALLOP_OK);
    }
  }
  assert_int_equal(n, 28);
}

/* "near-" families: within 2e-3 of where the modes change. */
TEST(boundaries_are_near)
{
  enum { COUNT = 30 };
  static const char *const names[] = { "near-start-velocity-zero", "near-sticking", "near-grazing" };
  for (int k = 0; k < 3; k++) {
    struct stress_case cases[COUNT];
    const struct stress_family *f = stress_families;
    while (strcmp(f->name, names[k]) != 0)
      f++;
    assert_int_equal(stress_make(f, QUADRATIC, 5, COUNT, cases), COUNT);
    int near = 0;
    for (int i = 0; i < COUNT; i++) {
      struct scallop_steady_result here, there;
      bool differs = false;
      assert_true(scallop_steady(&cases[i].motion.crawler, &here) >= 0);
      for (int p = 0; p < 8 && !differs; p++) {
        struct scallop_crawler c = cases[i].motion.crawler;
        double *const moved[] = { &c.T, &c.F1, &c.m2, &c.alpha };
        *moved[p / 2] *= p % 2 ? 1.002 : 0.998;
        if (scallop_steady(&c, &there) < 0)
          continue;
        for (int phase = 0; phase < 2; phase++)
          differs |= !modes_alike(&here.period.modes[phase], &there.period.modes[phase]);
      }
      near += differs;
    }
    assert_int_equal(near, COUNT);
  }
}

/* A trajectory against its closed form, and one whose start is a little off against the wrong one. */
TEST(trajectories)
{
  struct stress_case c = {
    .motion = { .of = OF_PHASE, .crawler = { 1.37, 0.85, 3.9, 1.21, 9.3, 0.31, 0.63, QUADRATIC } }, .periods = 500
  };
  struct stress_case j;
  struct scallop_steady_result s = steady_of(&c.motion.crawler);
  for (int k = 0; k < 3; k++) {
    c.motion.v0 = s.period.v_start * (1 + 0.02 * k);
    j = judged(&c);
    assert_int_equal(j.outcome, STRESS_SOLVED);
    CHECK_AT_MOST(j.number[Q_DXC].error, 8 * j.number[Q_DXC].unit);
    CHECK_AT_MOST(j.number[Q_V_END].error, 8 * j.number[Q_V_END].unit);
    CHECK_RELATIVE(j.number[Q_DXC].exact, 500 * s.period.displacement, 0.01);
  }
  c.motion.v0 = 0; /* starts from rest: other modes at first */
  j = judged(&c);
  assert_int_equal(j.outcome, STRESS_REFUSED);
}
