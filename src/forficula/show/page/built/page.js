/* forficula, MIT; with three.js and uPlot, MIT: see LICENSES.txt; sources 3a47afeeaafc0877a1a54f236b7e72d9a2da7583299aee0e0f74f37c65626ef3 */
(()=>{function N(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))s.includes("-")||s==="role"?i.setAttribute(s,r):i[s]=r;return i.append(...e),i}function Za(n){let t="http://www.w3.org/2000/svg",e=document.createElementNS(t,"svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let i=document.createElementNS(t,"path");return i.setAttribute("d",n),e.append(i),e}function nr({colour:n,dash:t}){let e="http://www.w3.org/2000/svg",i=document.createElementNS(e,"svg");i.setAttribute("viewBox","0 0 24 8"),i.setAttribute("aria-hidden","true"),i.classList.add("sample");let s=document.createElementNS(e,"path");return s.setAttribute("d","M0 4H24"),s.setAttribute("stroke",n),s.setAttribute("stroke-dasharray",t.join(" ")),i.append(s),i}var Gs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Hs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},fp=0,xu=1,pp=2;var xa=1,mp=2,oo=3,Ws=0,$n=1,Fn=2,cr=0,ao=1,yu=2,vu=3,bu=4,gp=5;var hr=100,_p=101,xp=102,yp=103,vp=104,bp=200,Sp=201,Mp=202,wp=203,Su=204,Mu=205,Ap=206,Tp=207,Ep=208,Cp=209,Rp=210,Pp=211,Ip=212,Lp=213,Np=214,bl=0,Sl=1,Ml=2,Zr=3,wl=4,Al=5,Tl=6,El=7,Ql=0,Dp=1,Up=2,Xi=0,wu=1,Au=2,Tu=3,Eu=4,Cu=5,Ru=6,Pu=7;var Iu=300,ur=301,lo=302,tc=303,ec=304,Cl=1e3,Vi=1001,Rl=1002,Rn=1003,Op=1004;var ya=1005;var Xn=1006,nc=1007;var ms=1008;var Kn=1009,Lu=1010,Nu=1011,co=1012,ic=1013,Ei=1014,_i=1015,Ci=1016,sc=1017,rc=1018,dr=1020,Du=35902,Uu=35899,Ou=1021,Fu=1022,Ri=1023,cs=1026,gs=1027,oc=1028,ac=1029,Xs=1030,lc=1031;var cc=1033,va=33776,ba=33777,Sa=33778,Ma=33779,hc=35840,uc=35841,dc=35842,fc=35843,pc=36196,mc=37492,gc=37496,_c=37488,xc=37489,wa=37490,yc=37491,vc=37808,bc=37809,Sc=37810,Mc=37811,wc=37812,Ac=37813,Tc=37814,Ec=37815,Cc=37816,Rc=37817,Pc=37818,Ic=37819,Lc=37820,Nc=37821,Dc=36492,Uc=36494,Oc=36495,Fc=36283,kc=36284,Aa=36285,Bc=36286;var Zo=2300,Pl=2301,yl=2302,hu=2303,uu=2400,du=2401,fu=2402;var Fp=3200;var zc=0,kp=1,_s="",si="srgb",Ko="srgb-linear",Jo="linear",Ae="srgb";var vl=7680,ku=7681;var Bu=517;var Bp=519,zp=512,Vp=513,Gp=514,zu=515,Hp=516,Wp=517,Vu=518,Gu=519,Xp=35044,Ta=35048;var Hu="300 es",gi=2e3,Kr=2001;function cx(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function hx(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function jo(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function $p(){let n=jo("canvas");return n.style.display="block",n}var Uf={},Jr=null;function Wu(...n){let t="THREE."+n.shift();Jr?Jr("log",t,...n):console.log(t,...n)}function qp(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function $t(...n){n=qp(n);let t="THREE."+n.shift();if(Jr)Jr("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function jt(...n){n=qp(n);let t="THREE."+n.shift();if(Jr)Jr("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function $o(...n){let t=n.join(" ");t in Uf||(Uf[t]=!0,$t(...n))}function Yp(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Zp={[bl]:bl,[Ml]:Tl,[wl]:wl,[Zr]:Al,[Sl]:Sl,[Tl]:Ml,[El]:El,[Al]:Zr},Ti=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Dn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Of=1234567,qo=Math.PI/180,jr=180/Math.PI;function ho(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Dn[n&255]+Dn[n>>8&255]+Dn[n>>16&255]+Dn[n>>24&255]+"-"+Dn[t&255]+Dn[t>>8&255]+"-"+Dn[t>>16&15|64]+Dn[t>>24&255]+"-"+Dn[e&63|128]+Dn[e>>8&255]+"-"+Dn[e>>16&255]+Dn[e>>24&255]+Dn[i&255]+Dn[i>>8&255]+Dn[i>>16&255]+Dn[i>>24&255]).toLowerCase()}function fe(n,t,e){return Math.max(t,Math.min(e,n))}function Xu(n,t){return(n%t+t)%t}function ux(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function dx(n,t,e){return n!==t?(e-n)/(t-n):0}function Yo(n,t,e){return(1-e)*n+e*t}function fx(n,t,e,i){return Yo(n,t,1-Math.exp(-e*i))}function px(n,t=1){return t-Math.abs(Xu(n,t*2)-t)}function mx(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function gx(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function _x(n,t){return n+Math.floor(Math.random()*(t-n+1))}function xx(n,t){return n+Math.random()*(t-n)}function yx(n){return n*(.5-Math.random())}function vx(n){n!==void 0&&(Of=n);let t=Of+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function bx(n){return n*qo}function Sx(n){return n*jr}function Mx(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function wx(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function $u(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Ax(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),h=o((t+i)/2),u=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),m=o((i-t)/2);switch(s){case"XYX":n.set(a*h,l*u,l*d,a*c);break;case"YZY":n.set(l*d,a*h,l*u,a*c);break;case"ZXZ":n.set(l*u,l*d,a*h,a*c);break;case"XZX":n.set(a*h,l*m,l*f,a*c);break;case"YXY":n.set(l*f,a*h,l*m,a*c);break;case"ZYZ":n.set(l*m,l*f,a*h,a*c);break;default:$t("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function qu(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Kp(n,t){if(t.constructor===Float32Array)return n;let e=qu(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Jp(n,t){if(t.constructor===Float32Array)return n;let e=qu(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Yu={DEG2RAD:qo,RAD2DEG:jr,generateUUID:ho,clamp:fe,euclideanModulo:Xu,mapLinear:ux,inverseLerp:dx,lerp:Yo,damp:fx,pingpong:px,smoothstep:mx,smootherstep:gx,randInt:_x,randFloat:xx,randFloatSpread:yx,seededRandom:vx,degToRad:bx,radToDeg:Sx,isPowerOfTwo:Mx,ceilPowerOfTwo:wx,floorPowerOfTwo:$u,setQuaternionFromProperEuler:Ax,normalize:Jp,denormalize:Kp},Yt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=fe(this.x,t.x,e.x),this.y=fe(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=fe(this.x,t,e),this.y=fe(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(fe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(fe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},oi=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],u=i[s+3],d=r[o+0],f=r[o+1],m=r[o+2],_=r[o+3];if(u!==_||l!==d||c!==f||h!==m){let p=l*d+c*f+h*m+u*_;p<0&&(d=-d,f=-f,m=-m,_=-_,p=-p);let g=1-a;if(p<.9995){let x=Math.acos(p),A=Math.sin(x);g=Math.sin(g*x)/A,a=Math.sin(a*x)/A,l=l*g+d*a,c=c*g+f*a,h=h*g+m*a,u=u*g+_*a}else{l=l*g+d*a,c=c*g+f*a,h=h*g+m*a,u=u*g+_*a;let x=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=x,c*=x,h*=x,u*=x}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],u=r[o],d=r[o+1],f=r[o+2],m=r[o+3];return t[e]=a*m+h*u+l*f-c*d,t[e+1]=l*m+h*d+c*u-a*f,t[e+2]=c*m+h*f+a*d-l*u,t[e+3]=h*m-a*u-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),u=a(r/2),d=l(i/2),f=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*m,this._y=c*f*u-d*h*m,this._z=c*h*m+d*f*u,this._w=c*h*u-d*f*m;break;case"YXZ":this._x=d*h*u+c*f*m,this._y=c*f*u-d*h*m,this._z=c*h*m-d*f*u,this._w=c*h*u+d*f*m;break;case"ZXY":this._x=d*h*u-c*f*m,this._y=c*f*u+d*h*m,this._z=c*h*m+d*f*u,this._w=c*h*u-d*f*m;break;case"ZYX":this._x=d*h*u-c*f*m,this._y=c*f*u+d*h*m,this._z=c*h*m-d*f*u,this._w=c*h*u+d*f*m;break;case"YZX":this._x=d*h*u+c*f*m,this._y=c*f*u+d*h*m,this._z=c*h*m-d*f*u,this._w=c*h*u-d*f*m;break;case"XZY":this._x=d*h*u-c*f*m,this._y=c*f*u-d*h*m,this._z=c*h*m+d*f*u,this._w=c*h*u+d*f*m;break;default:$t("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=i+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>u){let f=2*Math.sqrt(1+i-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-i-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(fe(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},X=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Ff.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Ff.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),h=2*(a*e-r*s),u=2*(r*i-o*e);return this.x=e+l*c+o*u-a*h,this.y=i+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=fe(this.x,t.x,e.x),this.y=fe(this.y,t.y,e.y),this.z=fe(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=fe(this.x,t,e),this.y=fe(this.y,t,e),this.z=fe(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(fe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Hh.copy(this).projectOnVector(t),this.sub(Hh)}reflect(t){return this.sub(Hh.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(fe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Hh=new X,Ff=new oi,ee=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],u=i[7],d=i[2],f=i[5],m=i[8],_=s[0],p=s[3],g=s[6],x=s[1],A=s[4],b=s[7],C=s[2],M=s[5],y=s[8];return r[0]=o*_+a*x+l*C,r[3]=o*p+a*A+l*M,r[6]=o*g+a*b+l*y,r[1]=c*_+h*x+u*C,r[4]=c*p+h*A+u*M,r[7]=c*g+h*b+u*y,r[2]=d*_+f*x+m*C,r[5]=d*p+f*A+m*M,r[8]=d*g+f*b+m*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,m=e*u+i*d+s*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/m;return t[0]=u*_,t[1]=(s*c-h*i)*_,t[2]=(a*i-s*o)*_,t[3]=d*_,t[4]=(h*e-s*l)*_,t[5]=(s*r-a*e)*_,t[6]=f*_,t[7]=(i*l-c*e)*_,t[8]=(o*e-i*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return $o("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Wh.makeScale(t,e)),this}rotate(t){return $o("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Wh.makeRotation(-t)),this}translate(t,e){return $o("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Wh.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Wh=new ee,kf=new ee().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Bf=new ee().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Tx(){let n={enabled:!0,workingColorSpace:Ko,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ae&&(s.r=ls(s.r),s.g=ls(s.g),s.b=ls(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ae&&(s.r=Yr(s.r),s.g=Yr(s.g),s.b=Yr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===_s?Jo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ko]:{primaries:t,whitePoint:i,transfer:Jo,toXYZ:kf,fromXYZ:Bf,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:si},outputColorSpaceConfig:{drawingBufferColorSpace:si}},[si]:{primaries:t,whitePoint:i,transfer:Ae,toXYZ:kf,fromXYZ:Bf,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:si}}}),n}var _e=Tx();function ls(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Yr(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Dr,Il=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Dr===void 0&&(Dr=jo("canvas")),Dr.width=t.width,Dr.height=t.height;let s=Dr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Dr}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=jo("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ls(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(ls(e[i]/255)*255):e[i]=ls(e[i]);return{data:e,width:t.width,height:t.height}}else return $t("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Ex=0,Qr=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Ex++}),this.uuid=ho(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Xh(s[o].image)):r.push(Xh(s[o]))}else r=Xh(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Xh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Il.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:($t("Texture: Unable to serialize Texture."),{})}var Cx=0,$h=new X,Zn=class n extends Ti{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Vi,s=Vi,r=Xn,o=ms,a=Ri,l=Kn,c=n.DEFAULT_ANISOTROPY,h=_s){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Cx++}),this.uuid=ho(),this.name="",this.source=new Qr(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Yt(0,0),this.repeat=new Yt(1,1),this.center=new Yt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ee,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize($h).x}get height(){return this.source.getSize($h).y}get depth(){return this.source.getSize($h).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){$t(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){$t(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Iu)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Cl:t.x=t.x-Math.floor(t.x);break;case Vi:t.x=t.x<0?0:1;break;case Rl:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Cl:t.y=t.y-Math.floor(t.y);break;case Vi:t.y=t.y<0?0:1;break;case Rl:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Zn.DEFAULT_IMAGE=null;Zn.DEFAULT_MAPPING=Iu;Zn.DEFAULT_ANISOTROPY=1;var $e=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],m=l[9],_=l[2],p=l[6],g=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-_)<.01&&Math.abs(m-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+_)<.1&&Math.abs(m+p)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let A=(c+1)/2,b=(f+1)/2,C=(g+1)/2,M=(h+d)/4,y=(u+_)/4,S=(m+p)/4;return A>b&&A>C?A<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(A),s=M/i,r=y/i):b>C?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=M/s,r=S/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=y/r,s=S/r),this.set(i,s,r,e),this}let x=Math.sqrt((p-m)*(p-m)+(u-_)*(u-_)+(d-h)*(d-h));return Math.abs(x)<.001&&(x=1),this.x=(p-m)/x,this.y=(u-_)/x,this.z=(d-h)/x,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=fe(this.x,t.x,e.x),this.y=fe(this.y,t.y,e.y),this.z=fe(this.z,t.z,e.z),this.w=fe(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=fe(this.x,t,e),this.y=fe(this.y,t,e),this.z=fe(this.z,t,e),this.w=fe(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(fe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Ll=class extends Ti{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Xn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new $e(0,0,t,e),this.scissorTest=!1,this.viewport=new $e(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Zn({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Xn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Qr(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ai=class extends Ll{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Qo=class extends Zn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Rn,this.minFilter=Rn,this.wrapR=Vi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Nl=class extends Zn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Rn,this.minFilter=Rn,this.wrapR=Vi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var pe=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,h,u,d,f,m,_,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,h,u,d,f,m,_,p)}set(t,e,i,s,r,o,a,l,c,h,u,d,f,m,_,p){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=d,g[3]=f,g[7]=m,g[11]=_,g[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Ur.setFromMatrixColumn(t,0).length(),r=1/Ur.setFromMatrixColumn(t,1).length(),o=1/Ur.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,f=o*u,m=a*h,_=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=f+m*c,e[5]=d-_*c,e[9]=-a*l,e[2]=_-d*c,e[6]=m+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*h,f=l*u,m=c*h,_=c*u;e[0]=d+_*a,e[4]=m*a-f,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=f*a-m,e[6]=_+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*h,f=l*u,m=c*h,_=c*u;e[0]=d-_*a,e[4]=-o*u,e[8]=m+f*a,e[1]=f+m*a,e[5]=o*h,e[9]=_-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*h,f=o*u,m=a*h,_=a*u;e[0]=l*h,e[4]=m*c-f,e[8]=d*c+_,e[1]=l*u,e[5]=_*c+d,e[9]=f*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,m=a*l,_=a*c;e[0]=l*h,e[4]=_-d*u,e[8]=m*u+f,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*u+m,e[10]=d-_*u}else if(t.order==="XZY"){let d=o*l,f=o*c,m=a*l,_=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+_,e[5]=o*h,e[9]=f*u-m,e[2]=m*u-f,e[6]=a*h,e[10]=_*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Rx,t,Px)}lookAt(t,e,i){let s=this.elements;return ni.subVectors(t,e),ni.lengthSq()===0&&(ni.z=1),ni.normalize(),Ps.crossVectors(i,ni),Ps.lengthSq()===0&&(Math.abs(i.z)===1?ni.x+=1e-4:ni.z+=1e-4,ni.normalize(),Ps.crossVectors(i,ni)),Ps.normalize(),Ka.crossVectors(ni,Ps),s[0]=Ps.x,s[4]=Ka.x,s[8]=ni.x,s[1]=Ps.y,s[5]=Ka.y,s[9]=ni.y,s[2]=Ps.z,s[6]=Ka.z,s[10]=ni.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],u=i[5],d=i[9],f=i[13],m=i[2],_=i[6],p=i[10],g=i[14],x=i[3],A=i[7],b=i[11],C=i[15],M=s[0],y=s[4],S=s[8],P=s[12],I=s[1],R=s[5],F=s[9],z=s[13],U=s[2],G=s[6],q=s[10],H=s[14],lt=s[3],K=s[7],Q=s[11],it=s[15];return r[0]=o*M+a*I+l*U+c*lt,r[4]=o*y+a*R+l*G+c*K,r[8]=o*S+a*F+l*q+c*Q,r[12]=o*P+a*z+l*H+c*it,r[1]=h*M+u*I+d*U+f*lt,r[5]=h*y+u*R+d*G+f*K,r[9]=h*S+u*F+d*q+f*Q,r[13]=h*P+u*z+d*H+f*it,r[2]=m*M+_*I+p*U+g*lt,r[6]=m*y+_*R+p*G+g*K,r[10]=m*S+_*F+p*q+g*Q,r[14]=m*P+_*z+p*H+g*it,r[3]=x*M+A*I+b*U+C*lt,r[7]=x*y+A*R+b*G+C*K,r[11]=x*S+A*F+b*q+C*Q,r[15]=x*P+A*z+b*H+C*it,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],f=t[14],m=t[3],_=t[7],p=t[11],g=t[15],x=l*f-c*d,A=a*f-c*u,b=a*d-l*u,C=o*f-c*h,M=o*d-l*h,y=o*u-a*h;return e*(_*x-p*A+g*b)-i*(m*x-p*C+g*M)+s*(m*A-_*C+g*y)-r*(m*b-_*M+p*y)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-i*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],m=t[12],_=t[13],p=t[14],g=t[15],x=e*a-i*o,A=e*l-s*o,b=e*c-r*o,C=i*l-s*a,M=i*c-r*a,y=s*c-r*l,S=h*_-u*m,P=h*p-d*m,I=h*g-f*m,R=u*p-d*_,F=u*g-f*_,z=d*g-f*p,U=x*z-A*F+b*R+C*I-M*P+y*S;if(U===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/U;return t[0]=(a*z-l*F+c*R)*G,t[1]=(s*F-i*z-r*R)*G,t[2]=(_*y-p*M+g*C)*G,t[3]=(d*M-u*y-f*C)*G,t[4]=(l*I-o*z-c*P)*G,t[5]=(e*z-s*I+r*P)*G,t[6]=(p*b-m*y-g*A)*G,t[7]=(h*y-d*b+f*A)*G,t[8]=(o*F-a*I+c*S)*G,t[9]=(i*I-e*F-r*S)*G,t[10]=(m*M-_*b+g*x)*G,t[11]=(u*b-h*M-f*x)*G,t[12]=(a*P-o*R-l*S)*G,t[13]=(e*R-i*P+s*S)*G,t[14]=(_*A-m*C-p*x)*G,t[15]=(h*C-u*A+d*x)*G,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,m=r*u,_=o*h,p=o*u,g=a*u,x=l*c,A=l*h,b=l*u,C=i.x,M=i.y,y=i.z;return s[0]=(1-(_+g))*C,s[1]=(f+b)*C,s[2]=(m-A)*C,s[3]=0,s[4]=(f-b)*M,s[5]=(1-(d+g))*M,s[6]=(p+x)*M,s[7]=0,s[8]=(m+A)*y,s[9]=(p-x)*y,s[10]=(1-(d+_))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Ur.set(s[0],s[1],s[2]).length(),a=Ur.set(s[4],s[5],s[6]).length(),l=Ur.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Mi.copy(this);let c=1/o,h=1/a,u=1/l;return Mi.elements[0]*=c,Mi.elements[1]*=c,Mi.elements[2]*=c,Mi.elements[4]*=h,Mi.elements[5]*=h,Mi.elements[6]*=h,Mi.elements[8]*=u,Mi.elements[9]*=u,Mi.elements[10]*=u,e.setFromRotationMatrix(Mi),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=gi,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),m,_;if(l)m=r/(o-r),_=o*r/(o-r);else if(a===gi)m=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===Kr)m=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=gi,l=!1){let c=this.elements,h=2/(e-t),u=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),m,_;if(l)m=1/(o-r),_=o/(o-r);else if(a===gi)m=-2/(o-r),_=-(o+r)/(o-r);else if(a===Kr)m=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Ur=new X,Mi=new pe,Rx=new X(0,0,0),Px=new X(1,1,1),Ps=new X,Ka=new X,ni=new X,zf=new pe,Vf=new oi,hs=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(fe(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-fe(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(fe(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-fe(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(fe(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-fe(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:$t("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return zf.makeRotationFromQuaternion(t),this.setFromRotationMatrix(zf,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Vf.setFromEuler(this),this.setFromQuaternion(Vf,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};hs.DEFAULT_ORDER="XYZ";var to=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Ix=0,Gf=new X,Or=new oi,is=new pe,Ja=new X,Bo=new X,Lx=new X,Nx=new oi,Hf=new X(1,0,0),Wf=new X(0,1,0),Xf=new X(0,0,1),$f={type:"added"},Dx={type:"removed"},Fr={type:"childadded",child:null},qh={type:"childremoved",child:null},In=class n extends Ti{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Ix++}),this.uuid=ho(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new X,e=new hs,i=new oi,s=new X(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new pe},normalMatrix:{value:new ee}}),this.matrix=new pe,this.matrixWorld=new pe,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new to,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Or.setFromAxisAngle(t,e),this.quaternion.multiply(Or),this}rotateOnWorldAxis(t,e){return Or.setFromAxisAngle(t,e),this.quaternion.premultiply(Or),this}rotateX(t){return this.rotateOnAxis(Hf,t)}rotateY(t){return this.rotateOnAxis(Wf,t)}rotateZ(t){return this.rotateOnAxis(Xf,t)}translateOnAxis(t,e){return Gf.copy(t).applyQuaternion(this.quaternion),this.position.add(Gf.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Hf,t)}translateY(t){return this.translateOnAxis(Wf,t)}translateZ(t){return this.translateOnAxis(Xf,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(is.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Ja.copy(t):Ja.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Bo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?is.lookAt(Bo,Ja,this.up):is.lookAt(Ja,Bo,this.up),this.quaternion.setFromRotationMatrix(is),s&&(is.extractRotation(s.matrixWorld),Or.setFromRotationMatrix(is),this.quaternion.premultiply(Or.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(jt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent($f),Fr.child=t,this.dispatchEvent(Fr),Fr.child=null):jt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Dx),qh.child=t,this.dispatchEvent(qh),qh.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),is.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),is.multiply(t.parent.matrixWorld)),t.applyMatrix4(is),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent($f),Fr.child=t,this.dispatchEvent(Fr),Fr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Bo,t,Lx),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Bo,Nx,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),m=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),m.length>0&&(i.nodes=m)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};In.DEFAULT_UP=new X(0,1,0);In.DEFAULT_MATRIX_AUTO_UPDATE=!0;In.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var On=class extends In{constructor(){super(),this.isGroup=!0,this.type="Group"}},Ux={type:"move"},eo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new On,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new On,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new On,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let _ of t.hand.values()){let p=e.getJointPose(_,i),g=this._getHandJoint(c,_);p!==null&&(g.matrix.fromArray(p.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=p.radius),g.visible=p!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,m=.005;c.inputState.pinching&&d>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Ux)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new On;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},jp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Is={h:0,s:0,l:0},ja={h:0,s:0,l:0};function Yh(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var Qt=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=si){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,_e.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=_e.workingColorSpace){return this.r=t,this.g=e,this.b=i,_e.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=_e.workingColorSpace){if(t=Xu(t,1),e=fe(e,0,1),i=fe(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Yh(o,r,t+1/3),this.g=Yh(o,r,t),this.b=Yh(o,r,t-1/3)}return _e.colorSpaceToWorking(this,s),this}setStyle(t,e=si){function i(r){r!==void 0&&parseFloat(r)<1&&$t("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:$t("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);$t("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=si){let i=jp[t.toLowerCase()];return i!==void 0?this.setHex(i,e):$t("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ls(t.r),this.g=ls(t.g),this.b=ls(t.b),this}copyLinearToSRGB(t){return this.r=Yr(t.r),this.g=Yr(t.g),this.b=Yr(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=si){return _e.workingToColorSpace(Un.copy(this),t),Math.round(fe(Un.r*255,0,255))*65536+Math.round(fe(Un.g*255,0,255))*256+Math.round(fe(Un.b*255,0,255))}getHexString(t=si){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=_e.workingColorSpace){_e.workingToColorSpace(Un.copy(this),e);let i=Un.r,s=Un.g,r=Un.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=_e.workingColorSpace){return _e.workingToColorSpace(Un.copy(this),e),t.r=Un.r,t.g=Un.g,t.b=Un.b,t}getStyle(t=si){_e.workingToColorSpace(Un.copy(this),t);let e=Un.r,i=Un.g,s=Un.b;return t!==si?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Is),this.setHSL(Is.h+t,Is.s+e,Is.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Is),t.getHSL(ja);let i=Yo(Is.h,ja.h,e),s=Yo(Is.s,ja.s,e),r=Yo(Is.l,ja.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Un=new Qt;Qt.NAMES=jp;var ta=class extends In{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new hs,this.environmentIntensity=1,this.environmentRotation=new hs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},wi=new X,ss=new X,Zh=new X,rs=new X,kr=new X,Br=new X,qf=new X,Kh=new X,Jh=new X,jh=new X,Qh=new $e,tu=new $e,eu=new $e,Us=class n{constructor(t=new X,e=new X,i=new X){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),wi.subVectors(t,e),s.cross(wi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){wi.subVectors(s,e),ss.subVectors(i,e),Zh.subVectors(t,e);let o=wi.dot(wi),a=wi.dot(ss),l=wi.dot(Zh),c=ss.dot(ss),h=ss.dot(Zh),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,m=(o*h-a*l)*d;return r.set(1-f-m,m,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,rs)===null?!1:rs.x>=0&&rs.y>=0&&rs.x+rs.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,rs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,rs.x),l.addScaledVector(o,rs.y),l.addScaledVector(a,rs.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return Qh.setScalar(0),tu.setScalar(0),eu.setScalar(0),Qh.fromBufferAttribute(t,e),tu.fromBufferAttribute(t,i),eu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Qh,r.x),o.addScaledVector(tu,r.y),o.addScaledVector(eu,r.z),o}static isFrontFacing(t,e,i,s){return wi.subVectors(i,e),ss.subVectors(t,e),wi.cross(ss).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return wi.subVectors(this.c,this.b),ss.subVectors(this.a,this.b),wi.cross(ss).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;kr.subVectors(s,i),Br.subVectors(r,i),Kh.subVectors(t,i);let l=kr.dot(Kh),c=Br.dot(Kh);if(l<=0&&c<=0)return e.copy(i);Jh.subVectors(t,s);let h=kr.dot(Jh),u=Br.dot(Jh);if(h>=0&&u<=h)return e.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(i).addScaledVector(kr,o);jh.subVectors(t,r);let f=kr.dot(jh),m=Br.dot(jh);if(m>=0&&f<=m)return e.copy(r);let _=f*c-l*m;if(_<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(i).addScaledVector(Br,a);let p=h*m-f*u;if(p<=0&&u-h>=0&&f-m>=0)return qf.subVectors(r,s),a=(u-h)/(u-h+(f-m)),e.copy(s).addScaledVector(qf,a);let g=1/(p+_+d);return o=_*g,a=d*g,e.copy(i).addScaledVector(kr,o).addScaledVector(Br,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Gi=class{constructor(t=new X(1/0,1/0,1/0),e=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Ai.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Ai.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Ai.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ai):Ai.fromBufferAttribute(r,o),Ai.applyMatrix4(t.matrixWorld),this.expandByPoint(Ai);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Qa.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Qa.copy(i.boundingBox)),Qa.applyMatrix4(t.matrixWorld),this.union(Qa)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ai),Ai.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(zo),tl.subVectors(this.max,zo),zr.subVectors(t.a,zo),Vr.subVectors(t.b,zo),Gr.subVectors(t.c,zo),Ls.subVectors(Vr,zr),Ns.subVectors(Gr,Vr),ir.subVectors(zr,Gr);let e=[0,-Ls.z,Ls.y,0,-Ns.z,Ns.y,0,-ir.z,ir.y,Ls.z,0,-Ls.x,Ns.z,0,-Ns.x,ir.z,0,-ir.x,-Ls.y,Ls.x,0,-Ns.y,Ns.x,0,-ir.y,ir.x,0];return!nu(e,zr,Vr,Gr,tl)||(e=[1,0,0,0,1,0,0,0,1],!nu(e,zr,Vr,Gr,tl))?!1:(el.crossVectors(Ls,Ns),e=[el.x,el.y,el.z],nu(e,zr,Vr,Gr,tl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ai).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ai).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(os[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),os[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),os[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),os[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),os[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),os[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),os[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),os[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(os),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},os=[new X,new X,new X,new X,new X,new X,new X,new X],Ai=new X,Qa=new Gi,zr=new X,Vr=new X,Gr=new X,Ls=new X,Ns=new X,ir=new X,zo=new X,tl=new X,el=new X,sr=new X;function nu(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){sr.fromArray(n,r);let a=s.x*Math.abs(sr.x)+s.y*Math.abs(sr.y)+s.z*Math.abs(sr.z),l=t.dot(sr),c=e.dot(sr),h=i.dot(sr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var un=new X,nl=new Yt,Ox=0,nn=class extends Ti{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ox++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Xp,this.updateRanges=[],this.gpuType=_i,this.version=0,this._normalizationScale=t!==void 0?qu(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)nl.fromBufferAttribute(this,e),nl.applyMatrix3(t),this.setXY(e,nl.x,nl.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)un.fromBufferAttribute(this,e),un.applyMatrix3(t),this.setXYZ(e,un.x,un.y,un.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)un.fromBufferAttribute(this,e),un.applyMatrix4(t),this.setXYZ(e,un.x,un.y,un.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)un.fromBufferAttribute(this,e),un.applyNormalMatrix(t),this.setXYZ(e,un.x,un.y,un.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)un.fromBufferAttribute(this,e),un.transformDirection(t),this.setXYZ(e,un.x,un.y,un.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Kp(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Jp(t,this.array)}};var ea=class extends nn{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var na=class extends nn{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Qe=class extends nn{constructor(t,e,i){super(new Float32Array(t),e,i)}},Fx=new Gi,Vo=new X,iu=new X,us=class{constructor(t=new X,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):Fx.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Vo.subVectors(t,this.center);let e=Vo.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Vo,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(iu.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Vo.copy(t.center).add(iu)),this.expandByPoint(Vo.copy(t.center).sub(iu))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},kx=0,mi=new pe,su=new In,Hr=new X,ii=new Gi,Go=new Gi,Cn=new X,gn=class n extends Ti{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:kx++}),this.uuid=ho(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(cx(t)?na:ea)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ee().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return mi.makeRotationFromQuaternion(t),this.applyMatrix4(mi),this}rotateX(t){return mi.makeRotationX(t),this.applyMatrix4(mi),this}rotateY(t){return mi.makeRotationY(t),this.applyMatrix4(mi),this}rotateZ(t){return mi.makeRotationZ(t),this.applyMatrix4(mi),this}translate(t,e,i){return mi.makeTranslation(t,e,i),this.applyMatrix4(mi),this}scale(t,e,i){return mi.makeScale(t,e,i),this.applyMatrix4(mi),this}lookAt(t){return su.lookAt(t),su.updateMatrix(),this.applyMatrix4(su.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Hr).negate(),this.translate(Hr.x,Hr.y,Hr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Qe(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&$t("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Gi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){jt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];ii.setFromBufferAttribute(r),this.morphTargetsRelative?(Cn.addVectors(this.boundingBox.min,ii.min),this.boundingBox.expandByPoint(Cn),Cn.addVectors(this.boundingBox.max,ii.max),this.boundingBox.expandByPoint(Cn)):(this.boundingBox.expandByPoint(ii.min),this.boundingBox.expandByPoint(ii.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&jt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new us);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){jt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(t){let i=this.boundingSphere.center;if(ii.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Go.setFromBufferAttribute(a),this.morphTargetsRelative?(Cn.addVectors(ii.min,Go.min),ii.expandByPoint(Cn),Cn.addVectors(ii.max,Go.max),ii.expandByPoint(Cn)):(ii.expandByPoint(Go.min),ii.expandByPoint(Go.max))}ii.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Cn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Cn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Cn.fromBufferAttribute(a,c),l&&(Hr.fromBufferAttribute(t,c),Cn.add(Hr)),s=Math.max(s,i.distanceToSquared(Cn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&jt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){jt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new nn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let P=0;P<i.count;P++)a[P]=new X,l[P]=new X;let h=new X,u=new X,d=new X,f=new Yt,m=new Yt,_=new Yt,p=new X,g=new X;function x(P,I,R){c[P]=c[I]=c[R]=1,h.fromBufferAttribute(i,P),u.fromBufferAttribute(i,I),d.fromBufferAttribute(i,R),f.fromBufferAttribute(r,P),m.fromBufferAttribute(r,I),_.fromBufferAttribute(r,R),u.sub(h),d.sub(h),m.sub(f),_.sub(f);let F=1/(m.x*_.y-_.x*m.y);isFinite(F)&&(p.copy(u).multiplyScalar(_.y).addScaledVector(d,-m.y).multiplyScalar(F),g.copy(d).multiplyScalar(m.x).addScaledVector(u,-_.x).multiplyScalar(F),a[P].add(p),a[I].add(p),a[R].add(p),l[P].add(g),l[I].add(g),l[R].add(g))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let P=0,I=A.length;P<I;++P){let R=A[P],F=R.start,z=R.count;for(let U=F,G=F+z;U<G;U+=3)x(t.getX(U+0),t.getX(U+1),t.getX(U+2))}let b=new X,C=new X,M=new X,y=new X;function S(P){M.fromBufferAttribute(s,P),y.copy(M);let I=a[P];b.copy(I),b.sub(M.multiplyScalar(M.dot(I))).normalize(),C.crossVectors(y,I);let F=C.dot(l[P])<0?-1:1;o.setXYZW(P,b.x,b.y,b.z,F)}for(let P=0,I=i.count;P<I;++P)c[P]&&S(P);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new nn(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new X,r=new X,o=new X,a=new X,l=new X,c=new X,h=new X,u=new X;if(t)for(let d=0,f=t.count;d<f;d+=3){let m=t.getX(d+0),_=t.getX(d+1),p=t.getX(d+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,p),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,p),a.add(h),l.add(h),c.add(h),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),i.setXYZ(d+0,h.x,h.y,h.z),i.setXYZ(d+1,h.x,h.y,h.z),i.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Cn.fromBufferAttribute(t,e),Cn.normalize(),t.setXYZ(e,Cn.x,Cn.y,Cn.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,m=0;for(let _=0,p=l.length;_<p;_++){a.isInterleavedBufferAttribute?f=l[_]*a.data.stride+a.offset:f=l[_]*h;for(let g=0;g<h;g++)d[m++]=c[f++]}return new nn(d,h,u)}if(this.index===null)return $t("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var ru=new X,Bx=new X,zx=new ee,ri=class{constructor(t=new X(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=ru.subVectors(i,e).cross(Bx.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(ru),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||zx.getNormalMatrix(t),s=this.coplanarPoint(ru).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Vx=0,ds=class extends Ti{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Vx++}),this.uuid=ho(),this.name="",this.type="Material",this.blending=ao,this.side=Ws,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Su,this.blendDst=Mu,this.blendEquation=hr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Qt(0,0,0),this.blendAlpha=0,this.depthFunc=Zr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Bp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=vl,this.stencilZFail=vl,this.stencilZPass=vl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){$t(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){$t(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Qt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new ri().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Yt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Yt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var as=new X,ou=new X,il=new X,sl=new X,Os=class{constructor(t=new X,e=new X(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,as)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=as.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(as.copy(this.origin).addScaledVector(this.direction,e),as.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){ou.copy(t).add(e).multiplyScalar(.5),il.copy(e).sub(t).normalize(),sl.copy(this.origin).sub(ou);let r=t.distanceTo(e)*.5,o=-this.direction.dot(il),a=sl.dot(this.direction),l=-sl.dot(il),c=sl.lengthSq(),h=Math.abs(1-o*o),u,d,f,m;if(h>0)if(u=o*l-a,d=o*a-l,m=r*h,u>=0)if(d>=-m)if(d<=m){let _=1/h;u*=_,d*=_,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-m?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=m?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(ou).addScaledVector(il,d),f}intersectSphere(t,e){if(t.radius<0)return null;as.subVectors(t.center,this.origin);let i=as.dot(this.direction),s=as.dot(as)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,as)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,m=e.x-o.x,_=e.y-o.y,p=e.z-o.z,g=i.x-o.x,x=i.y-o.y,A=i.z-o.z,b=Math.abs(l),C=Math.abs(c),M=Math.abs(h),y,S,P,I,R,F,z,U,G,q,H,lt;if(b>=C&&b>=M?(P=l,F=u,G=m,lt=g,l>=0?(y=c,S=h,I=d,R=f,z=_,U=p,q=x,H=A):(y=h,S=c,I=f,R=d,z=p,U=_,q=A,H=x)):C>=M?(P=c,F=d,G=_,lt=x,c>=0?(y=h,S=l,I=f,R=u,z=p,U=m,q=A,H=g):(y=l,S=h,I=u,R=f,z=m,U=p,q=g,H=A)):(P=h,F=f,G=p,lt=A,h>=0?(y=l,S=c,I=u,R=d,z=m,U=_,q=g,H=x):(y=c,S=l,I=d,R=u,z=_,U=m,q=x,H=g)),P===0)return null;let K=y/P,Q=S/P,it=1/P,ft=I-K*F,dt=R-Q*F,tt=z-K*G,ut=U-Q*G,gt=q-K*lt,St=H-Q*lt,Mt=gt*ut-St*tt,Ht=ft*St-dt*gt,se=tt*dt-ut*ft;if(s){if(Mt<0||Ht<0||se<0)return null}else if((Mt<0||Ht<0||se<0)&&(Mt>0||Ht>0||se>0))return null;let Vt=Mt+Ht+se;if(Vt===0)return null;let he=it*(Mt*F+Ht*G+se*lt);return(Vt>0?he<0:he>0)?null:this.at(he/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ar=class extends ds{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Qt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new hs,this.combine=Ql,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Yf=new pe,rr=new Os,rl=new us,Zf=new X,ol=new X,al=new X,ll=new X,au=new X,cl=new X,Kf=new X,hl=new X,Ln=class extends In{constructor(t=new gn,e=new ar){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){cl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(au.fromBufferAttribute(u,t),o?cl.addScaledVector(au,h):cl.addScaledVector(au.sub(e),h))}e.add(cl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),rl.copy(i.boundingSphere),rl.applyMatrix4(r),rr.copy(t.ray).recast(t.near),!(rl.containsPoint(rr.origin)===!1&&(rr.intersectSphere(rl,Zf)===null||rr.origin.distanceToSquared(Zf)>(t.far-t.near)**2))&&(Yf.copy(r).invert(),rr.copy(t.ray).applyMatrix4(Yf),!(i.boundingBox!==null&&rr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,rr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,_=d.length;m<_;m++){let p=d[m],g=o[p.materialIndex],x=Math.max(p.start,f.start),A=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let b=x,C=A;b<C;b+=3){let M=a.getX(b),y=a.getX(b+1),S=a.getX(b+2);s=ul(this,g,t,i,c,h,u,M,y,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let p=m,g=_;p<g;p+=3){let x=a.getX(p),A=a.getX(p+1),b=a.getX(p+2);s=ul(this,o,t,i,c,h,u,x,A,b),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,_=d.length;m<_;m++){let p=d[m],g=o[p.materialIndex],x=Math.max(p.start,f.start),A=Math.min(l.count,Math.min(p.start+p.count,f.start+f.count));for(let b=x,C=A;b<C;b+=3){let M=b,y=b+1,S=b+2;s=ul(this,g,t,i,c,h,u,M,y,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),_=Math.min(l.count,f.start+f.count);for(let p=m,g=_;p<g;p+=3){let x=p,A=p+1,b=p+2;s=ul(this,o,t,i,c,h,u,x,A,b),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function Gx(n,t,e,i,s,r,o,a){let l;if(t.side===$n?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Ws,a),l===null)return null;hl.copy(a),hl.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(hl);return c<e.near||c>e.far?null:{distance:c,point:hl.clone(),object:n}}function ul(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,ol),n.getVertexPosition(l,al),n.getVertexPosition(c,ll);let h=Gx(n,t,e,i,ol,al,ll,Kf);if(h){let u=new X;Us.getBarycoord(Kf,ol,al,ll,u),s&&(h.uv=Us.getInterpolatedAttribute(s,a,l,c,u,new Yt)),r&&(h.uv1=Us.getInterpolatedAttribute(r,a,l,c,u,new Yt)),o&&(h.normal=Us.getInterpolatedAttribute(o,a,l,c,u,new X),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new X,materialIndex:0};Us.getNormal(ol,al,ll,d.normal),h.face=d,h.barycoord=u}return h}var ia=class extends Zn{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Rn,h=Rn,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var sa=class extends nn{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Wr=new pe,Jf=new pe,dl=[],jf=new Gi,Hx=new pe,Ho=new Ln,Wo=new us,li=class extends Ln{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new sa(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,Hx)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Gi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Wr),jf.copy(t.boundingBox).applyMatrix4(Wr),this.boundingBox.union(jf)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new us),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Wr),Wo.copy(t.boundingSphere).applyMatrix4(Wr),this.boundingSphere.union(Wo)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(Ho.geometry=this.geometry,Ho.material=this.material,Ho.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Wo.copy(this.boundingSphere),Wo.applyMatrix4(i),t.ray.intersectsSphere(Wo)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Wr),Jf.multiplyMatrices(i,Wr),Ho.matrixWorld=Jf,Ho.raycast(t,dl);for(let o=0,a=dl.length;o<a;o++){let l=dl[o];l.instanceId=r,l.object=this,e.push(l)}dl.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new sa(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new ia(new Float32Array(s*this.count),s,this.count,oc,_i));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},or=new us,Wx=new Yt(.5,.5),fl=new X,Fs=class{constructor(t=new ri,e=new ri,i=new ri,s=new ri,r=new ri,o=new ri){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=gi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],m=r[8],_=r[9],p=r[10],g=r[11],x=r[12],A=r[13],b=r[14],C=r[15];if(s[0].setComponents(c-o,f-h,g-m,C-x).normalize(),s[1].setComponents(c+o,f+h,g+m,C+x).normalize(),s[2].setComponents(c+a,f+u,g+_,C+A).normalize(),s[3].setComponents(c-a,f-u,g-_,C-A).normalize(),i)s[4].setComponents(l,d,p,b).normalize(),s[5].setComponents(c-l,f-d,g-p,C-b).normalize();else if(s[4].setComponents(c-l,f-d,g-p,C-b).normalize(),e===gi)s[5].setComponents(c+l,f+d,g+p,C+b).normalize();else if(e===Kr)s[5].setComponents(l,d,p,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),or.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),or.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(or)}intersectsSprite(t){or.center.set(0,0,0);let e=Wx.distanceTo(t.center);return or.radius=.7071067811865476+e,or.applyMatrix4(t.matrixWorld),this.intersectsSphere(or)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(fl.x=s.normal.x>0?t.max.x:t.min.x,fl.y=s.normal.y>0?t.max.y:t.min.y,fl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(fl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Qf=new pe,Dl=class n{constructor(){this.coordinateSystem=gi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Qf.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Fs),i[s].setFromProjectionMatrix(Qf,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Fs),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var ks=class extends ds{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Qt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Ul=new X,Ol=new X,tp=new pe,Xo=new Os,pl=new us,lu=new X,ep=new X,Fl=class extends In{constructor(t=new gn,e=new ks){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Ul.fromBufferAttribute(e,s-1),Ol.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Ul.distanceTo(Ol);t.setAttribute("lineDistance",new Qe(i,1))}else $t("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),pl.copy(i.boundingSphere),pl.applyMatrix4(s),pl.radius+=r,t.ray.intersectsSphere(pl)===!1)return;tp.copy(s).invert(),Xo.copy(t.ray).applyMatrix4(tp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,d=i.attributes.position;if(h!==null){let f=Math.max(0,o.start),m=Math.min(h.count,o.start+o.count);for(let _=f,p=m-1;_<p;_+=c){let g=h.getX(_),x=h.getX(_+1),A=ml(this,t,Xo,l,g,x,_);A&&e.push(A)}if(this.isLineLoop){let _=h.getX(m-1),p=h.getX(f),g=ml(this,t,Xo,l,_,p,m-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),m=Math.min(d.count,o.start+o.count);for(let _=f,p=m-1;_<p;_+=c){let g=ml(this,t,Xo,l,_,_+1,_);g&&e.push(g)}if(this.isLineLoop){let _=ml(this,t,Xo,l,m-1,f,m-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function ml(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Ul.fromBufferAttribute(a,s),Ol.fromBufferAttribute(a,r),e.distanceSqToSegment(Ul,Ol,lu,ep)>i)return;lu.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(lu);if(!(c<t.near||c>t.far))return{distance:c,point:ep.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var np=new X,ip=new X,lr=class extends Fl{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)np.fromBufferAttribute(e,s),ip.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+np.distanceTo(ip);t.setAttribute("lineDistance",new Qe(i,1))}else $t("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ra=class extends Zn{constructor(t=[],e=ur,i,s,r,o,a,l,c,h){super(t,e,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var fs=class extends Zn{constructor(t,e,i=Ei,s,r,o,a=Rn,l=Rn,c,h=cs,u=1){if(h!==cs&&h!==gs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Qr(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},oa=class extends fs{constructor(t,e=Ei,i=ur,s,r,o=Rn,a=Rn,l,c=cs){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,i,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},aa=class extends Zn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},no=class n extends gn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;m("z","y","x",-1,-1,i,e,t,o,r,0),m("z","y","x",1,-1,i,e,-t,o,r,1),m("x","z","y",1,1,t,i,e,s,o,2),m("x","z","y",1,-1,t,i,-e,s,o,3),m("x","y","z",1,-1,t,e,i,s,r,4),m("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Qe(c,3)),this.setAttribute("normal",new Qe(h,3)),this.setAttribute("uv",new Qe(u,2));function m(_,p,g,x,A,b,C,M,y,S,P){let I=b/y,R=C/S,F=b/2,z=C/2,U=M/2,G=y+1,q=S+1,H=0,lt=0,K=new X;for(let Q=0;Q<q;Q++){let it=Q*R-z;for(let ft=0;ft<G;ft++){let dt=ft*I-F;K[_]=dt*x,K[p]=it*A,K[g]=U,c.push(K.x,K.y,K.z),K[_]=0,K[p]=0,K[g]=M>0?1:-1,h.push(K.x,K.y,K.z),u.push(ft/y),u.push(1-Q/S),H+=1}}for(let Q=0;Q<S;Q++)for(let it=0;it<y;it++){let ft=d+it+G*Q,dt=d+it+G*(Q+1),tt=d+(it+1)+G*(Q+1),ut=d+(it+1)+G*Q;l.push(ft,dt,ut),l.push(dt,tt,ut),lt+=6}a.addGroup(f,lt,P),f+=lt,d+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Hi=class n extends gn{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],m=0,_=[],p=i/2,g=0;x(),o===!1&&(t>0&&A(!0),e>0&&A(!1)),this.setIndex(h),this.setAttribute("position",new Qe(u,3)),this.setAttribute("normal",new Qe(d,3)),this.setAttribute("uv",new Qe(f,2));function x(){let b=new X,C=new X,M=0,y=(e-t)/i;for(let S=0;S<=r;S++){let P=[],I=S/r,R=I*(e-t)+t;for(let F=0;F<=s;F++){let z=F/s,U=z*l+a,G=Math.sin(U),q=Math.cos(U);C.x=R*G,C.y=-I*i+p,C.z=R*q,u.push(C.x,C.y,C.z),b.set(G,y,q).normalize(),d.push(b.x,b.y,b.z),f.push(z,1-I),P.push(m++)}_.push(P)}for(let S=0;S<s;S++)for(let P=0;P<r;P++){let I=_[P][S],R=_[P+1][S],F=_[P+1][S+1],z=_[P][S+1];(t>0||P!==0)&&(h.push(I,R,z),M+=3),(e>0||P!==r-1)&&(h.push(R,F,z),M+=3)}c.addGroup(g,M,0),g+=M}function A(b){let C=m,M=new Yt,y=new X,S=0,P=b===!0?t:e,I=b===!0?1:-1;for(let F=1;F<=s;F++)u.push(0,p*I,0),d.push(0,I,0),f.push(.5,.5),m++;let R=m;for(let F=0;F<=s;F++){let U=F/s*l+a,G=Math.cos(U),q=Math.sin(U);y.x=P*q,y.y=p*I,y.z=P*G,u.push(y.x,y.y,y.z),d.push(0,I,0),M.x=G*.5+.5,M.y=q*.5*I+.5,f.push(M.x,M.y),m++}for(let F=0;F<s;F++){let z=C+F,U=R+F;b===!0?h.push(U,U+1,z):h.push(U+1,U,z),S+=3}c.addGroup(g,S,b===!0?1:2),g+=S}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},la=class n extends Hi{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var ca=class n extends gn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,u=t/a,d=e/l,f=[],m=[],_=[],p=[];for(let g=0;g<h;g++){let x=g*d-o;for(let A=0;A<c;A++){let b=A*u-r;m.push(b,-x,0),_.push(0,0,1),p.push(A/a),p.push(1-g/l)}}for(let g=0;g<l;g++)for(let x=0;x<a;x++){let A=x+c*g,b=x+c*(g+1),C=x+1+c*(g+1),M=x+1+c*g;f.push(A,b,M),f.push(b,C,M)}this.setIndex(f),this.setAttribute("position",new Qe(m,3)),this.setAttribute("normal",new Qe(_,3)),this.setAttribute("uv",new Qe(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var io=class n extends gn{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new X,d=new X,f=[],m=[],_=[],p=[];for(let g=0;g<=i;g++){let x=[],A=g/i,b=o+A*a,C=t*Math.cos(b),M=Math.sqrt(t*t-C*C),y=0;g===0&&o===0?y=.5/e:g===i&&l===Math.PI&&(y=-.5/e);for(let S=0;S<=e;S++){let P=S/e,I=s+P*r;u.x=-M*Math.cos(I),u.y=C,u.z=M*Math.sin(I),m.push(u.x,u.y,u.z),d.copy(u).normalize(),_.push(d.x,d.y,d.z),p.push(P+y,1-A),x.push(c++)}h.push(x)}for(let g=0;g<i;g++)for(let x=0;x<e;x++){let A=h[g][x+1],b=h[g][x],C=h[g+1][x],M=h[g+1][x+1];(g!==0||o>0)&&f.push(A,b,M),(g!==i-1||l<Math.PI)&&f.push(b,C,M)}this.setIndex(f),this.setAttribute("position",new Qe(m,3)),this.setAttribute("normal",new Qe(_,3)),this.setAttribute("uv",new Qe(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function fr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(sp(s))s.isRenderTargetTexture?($t("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(sp(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function kn(n){let t={};for(let e=0;e<n.length;e++){let i=fr(n[e]);for(let s in i)t[s]=i[s]}return t}function sp(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Xx(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Zu(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:_e.workingColorSpace}var Qp={clone:fr,merge:kn},$x=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,qx=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Wi=class extends ds{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=$x,this.fragmentShader=qx,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=fr(t.uniforms),this.uniformsGroups=Xx(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new Qt().setHex(s.value);break;case"v2":this.uniforms[i].value=new Yt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new X().fromArray(s.value);break;case"v4":this.uniforms[i].value=new $e().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ee().fromArray(s.value);break;case"m4":this.uniforms[i].value=new pe().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},kl=class extends Wi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var ps=class extends ds{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Qt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Qt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=zc,this.normalScale=new Yt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new hs,this.combine=Ql,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Bl=class extends ds{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Fp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},zl=class extends ds{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Xr(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function gl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Bs=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Vl=class extends Bs{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:uu,endingEnd:uu}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case du:r=t,a=2*e-i;break;case fu:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case du:o=t,l=2*i-e;break;case fu:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,m=(i-e)/(s-e),_=m*m,p=_*m,g=-d*p+2*d*_-d*m,x=(1+d)*p+(-1.5-2*d)*_+(-.5+d)*m+1,A=(-1-f)*p+(1.5+f)*_+.5*m,b=f*p-f*_;for(let C=0;C!==a;++C)r[C]=g*o[h+C]+x*o[c+C]+A*o[l+C]+b*o[u+C];return r}},Gl=class extends Bs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(i-e)/(s-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Hl=class extends Bs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Wl=class extends Bs{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let m=(i-e)/(s-e),_=1-m;for(let p=0;p!==a;++p)r[p]=o[c+p]*_+o[l+p]*m;return r}let d=a*2,f=t-1;for(let m=0;m!==a;++m){let _=o[c+m],p=o[l+m],g=f*d+m*2,x=u[g],A=u[g+1],b=t*d+m*2,C=h[b],M=h[b+1],y=Zx(i,e,x,C,s);r[m]=tm(y,_,A,M,p)}return r}};function tm(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function Yx(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function Zx(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=tm(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=Yx(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ci=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Xr(e,this.TimeBufferType),this.values=Xr(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Xr(t.times,Array),values:Xr(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),gl(t.settings)&&(i.settings={inTangents:Xr(t.settings.inTangents,Array),outTangents:Xr(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Hl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Gl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Vl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Wl(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Zo:e=this.InterpolantFactoryMethodDiscrete;break;case Pl:e=this.InterpolantFactoryMethodLinear;break;case yl:e=this.InterpolantFactoryMethodSmooth;break;case hu:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return $t("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Zo;case this.InterpolantFactoryMethodLinear:return Pl;case this.InterpolantFactoryMethodSmooth:return yl;case this.InterpolantFactoryMethodBezier:return hu}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;gl(this.settings)&&(rp(this.settings.inTangents,t),rp(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;gl(this.settings)&&(op(this.settings.inTangents,t),op(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(jt("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(jt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){jt("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){jt("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&hx(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){jt("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===yl,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*i,d=u-i,f=u+i;for(let m=0;m!==i;++m){let _=e[u+m];if(_!==e[d+m]||_!==e[f+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,gl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function rp(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function op(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}ci.prototype.ValueTypeName="";ci.prototype.TimeBufferType=Float32Array;ci.prototype.ValueBufferType=Float32Array;ci.prototype.DefaultInterpolation=Pl;var zs=class extends ci{constructor(t,e,i){super(t,e,i)}};zs.prototype.ValueTypeName="bool";zs.prototype.ValueBufferType=Array;zs.prototype.DefaultInterpolation=Zo;zs.prototype.InterpolantFactoryMethodLinear=void 0;zs.prototype.InterpolantFactoryMethodSmooth=void 0;var Xl=class extends ci{constructor(t,e,i,s){super(t,e,i,s)}};Xl.prototype.ValueTypeName="color";var $l=class extends ci{constructor(t,e,i,s){super(t,e,i,s)}};$l.prototype.ValueTypeName="number";var ql=class extends Bs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)oi.slerpFlat(r,0,o,c-a,o,c,l);return r}},ha=class extends ci{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new ql(this.times,this.values,this.getValueSize(),t)}};ha.prototype.ValueTypeName="quaternion";ha.prototype.InterpolantFactoryMethodSmooth=void 0;var Vs=class extends ci{constructor(t,e,i){super(t,e,i)}};Vs.prototype.ValueTypeName="string";Vs.prototype.ValueBufferType=Array;Vs.prototype.DefaultInterpolation=Zo;Vs.prototype.InterpolantFactoryMethodLinear=void 0;Vs.prototype.InterpolantFactoryMethodSmooth=void 0;var Yl=class extends ci{constructor(t,e,i,s){super(t,e,i,s)}};Yl.prototype.ValueTypeName="vector";var Zl=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],m=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},em=new Zl,Kl=class{constructor(t){this.manager=t!==void 0?t:em,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Kl.DEFAULT_MATERIAL_NAME="__DEFAULT";var ua=class extends In{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Qt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},da=class extends ua{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(In.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Qt(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},cu=new pe,ap=new X,lp=new X,Jl=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Yt(512,512),this.mapType=Kn,this.map=null,this.mapPass=null,this.matrix=new pe,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Fs,this._frameExtents=new Yt(1,1),this._viewportCount=1,this._viewports=[new $e(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;ap.setFromMatrixPosition(t.matrixWorld),e.position.copy(ap),lp.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(lp),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){cu.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(cu,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===Kr||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(cu)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},_l=new X,xl=new oi,zi=new X,fa=class extends In{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new pe,this.projectionMatrix=new pe,this.projectionMatrixInverse=new pe,this.coordinateSystem=gi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(_l,xl,zi),zi.x===1&&zi.y===1&&zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(_l,xl,zi.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(_l,xl,zi),zi.x===1&&zi.y===1&&zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(_l,xl,zi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ds=new X,cp=new Yt,hp=new Yt,Wn=class extends fa{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=jr*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(qo*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return jr*2*Math.atan(Math.tan(qo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Ds.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Ds.x,Ds.y).multiplyScalar(-t/Ds.z),Ds.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Ds.x,Ds.y).multiplyScalar(-t/Ds.z)}getViewSize(t,e){return this.getViewBounds(t,cp,hp),e.subVectors(hp,cp)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(qo*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var pa=class extends fa{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},pu=class extends Jl{constructor(){super(new pa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ma=class extends ua{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(In.DEFAULT_UP),this.updateMatrix(),this.target=new In,this.shadow=new pu}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var $r=-90,qr=1,so=class extends In{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Wn($r,qr,t,e);s.layers=this.layers,this.add(s);let r=new Wn($r,qr,t,e);r.layers=this.layers,this.add(r);let o=new Wn($r,qr,t,e);o.layers=this.layers,this.add(o);let a=new Wn($r,qr,t,e);a.layers=this.layers,this.add(a);let l=new Wn($r,qr,t,e);l.layers=this.layers,this.add(l);let c=new Wn($r,qr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===gi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Kr)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=_,t.setRenderTarget(i,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},jl=class extends Wn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Ku="\\[\\]\\.:\\/",Kx=new RegExp("["+Ku+"]","g"),Ju="[^"+Ku+"]",Jx="[^"+Ku.replace("\\.","")+"]",jx=/((?:WC+[\/:])*)/.source.replace("WC",Ju),Qx=/(WCOD+)?/.source.replace("WCOD",Jx),ty=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Ju),ey=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Ju),ny=new RegExp("^"+jx+Qx+ty+ey+"$"),iy=["material","materials","bones","map"],mu=class{constructor(t,e,i){let s=i||Ge.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Ge=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Kx,"")}static parseTrackName(t){let e=ny.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);iy.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){$t("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){jt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){jt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){jt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){jt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){jt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){jt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){jt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;jt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){jt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){jt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ge.Composite=mu;Ge.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ge.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ge.prototype.GetterByBindingType=[Ge.prototype._getValue_direct,Ge.prototype._getValue_array,Ge.prototype._getValue_arrayElement,Ge.prototype._getValue_toArray];Ge.prototype.SetterByBindingTypeAndVersioning=[[Ge.prototype._setValue_direct,Ge.prototype._setValue_direct_setNeedsUpdate,Ge.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_array,Ge.prototype._setValue_array_setNeedsUpdate,Ge.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_arrayElement,Ge.prototype._setValue_arrayElement_setNeedsUpdate,Ge.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_fromArray,Ge.prototype._setValue_fromArray_setNeedsUpdate,Ge.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var bC=new Float32Array(1);var up=new pe,ga=class{constructor(t,e,i=0,s=1/0){this.ray=new Os(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new to,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):jt("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return up.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(up),this}intersectObject(t,e=!0,i=[]){return gu(t,this,i,e),i.sort(dp),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)gu(t[s],this,i,e);return i.sort(dp),i}};function dp(n,t){return n.distance-t.distance}function gu(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)gu(r[o],t,e,!0)}}var ro=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=fe(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(fe(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var _u=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var _a=class extends Ti{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function ju(n,t,e,i){let s=sy(i);switch(e){case Ou:return n*t;case oc:return n*t/s.components*s.byteLength;case ac:return n*t/s.components*s.byteLength;case Xs:return n*t*2/s.components*s.byteLength;case lc:return n*t*2/s.components*s.byteLength;case Fu:return n*t*3/s.components*s.byteLength;case Ri:return n*t*4/s.components*s.byteLength;case cc:return n*t*4/s.components*s.byteLength;case va:case ba:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Sa:case Ma:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case uc:case fc:return Math.max(n,16)*Math.max(t,8)/4;case hc:case dc:return Math.max(n,8)*Math.max(t,8)/2;case pc:case mc:case _c:case xc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case gc:case wa:case yc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case vc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case bc:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Sc:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Mc:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case wc:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Ac:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Tc:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Ec:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Cc:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Rc:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Pc:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Ic:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Lc:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Nc:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Dc:case Uc:case Oc:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Fc:case kc:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Aa:case Bc:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function sy(n){switch(n){case Kn:case Lu:return{byteLength:1,components:1};case co:case Nu:case Ci:return{byteLength:2,components:1};case sc:case rc:return{byteLength:2,components:4};case Ei:case ic:case _i:return{byteLength:4,components:1};case Du:case Uu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?$t("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Mm(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function oy(n){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,l,c){let h=l.array,u=l.updateRanges;if(n.bindBuffer(c,a),u.length===0)n.bufferSubData(c,0,h);else{u.sort((f,m)=>f.start-m.start);let d=0;for(let f=1;f<u.length;f++){let m=u[d],_=u[f];_.start<=m.start+m.count+1?m.count=Math.max(m.count,_.start+_.count-m.start):(++d,u[d]=_)}u.length=d+1;for(let f=0,m=u.length;f<m;f++){let _=u[f];n.bufferSubData(c,_.start*h.BYTES_PER_ELEMENT,h,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var ay=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ly=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,cy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,hy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,uy=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,dy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,fy=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,py=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,my=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,gy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,_y=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,xy=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,yy=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,vy=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,by=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Sy=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,My=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,wy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Ay=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Ty=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Ey=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Cy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Ry=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Py=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Iy=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Ly=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ny=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Dy=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Uy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Oy="gl_FragColor = linearToOutputTexel( gl_FragColor );",Fy=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,ky=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,By=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,zy=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Vy=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Gy=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Hy=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Wy=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Xy=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,$y=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,qy=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Yy=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Zy=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Ky=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Jy=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,jy=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Qy=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,tv=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,ev=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,nv=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,iv=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,sv=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,rv=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,ov=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,av=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,lv=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,cv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,hv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,uv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,dv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,fv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,pv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,mv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,gv=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,_v=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,xv=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,yv=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,vv=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,bv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Sv=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Mv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,wv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Av=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Tv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Ev=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Cv=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Rv=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Pv=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Iv=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Lv=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Nv=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Dv=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Uv=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Ov=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Fv=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,kv=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Bv=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,zv=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Vv=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Gv=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Hv=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Wv=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Xv=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,$v=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,qv=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Yv=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Zv=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Kv=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Jv=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,jv=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Qv=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,tb=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,eb=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,nb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,ib=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,sb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,rb=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,ob=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,ab=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,lb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,cb=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,hb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ub=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,db=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,fb=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,pb=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,mb=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,gb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,_b=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,xb=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,yb=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,vb=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,bb=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Sb=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Mb=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,wb=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Ab=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Tb=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Eb=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Cb=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Rb=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Pb=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Ib=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Lb=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Nb=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Db=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Ub=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ob=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Fb=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,kb=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Bb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ce={alphahash_fragment:ay,alphahash_pars_fragment:ly,alphamap_fragment:cy,alphamap_pars_fragment:hy,alphatest_fragment:uy,alphatest_pars_fragment:dy,aomap_fragment:fy,aomap_pars_fragment:py,batching_pars_vertex:my,batching_vertex:gy,begin_vertex:_y,beginnormal_vertex:xy,bsdfs:yy,iridescence_fragment:vy,bumpmap_pars_fragment:by,clipping_planes_fragment:Sy,clipping_planes_pars_fragment:My,clipping_planes_pars_vertex:wy,clipping_planes_vertex:Ay,color_fragment:Ty,color_pars_fragment:Ey,color_pars_vertex:Cy,color_vertex:Ry,common:Py,defaultnormal_vertex:Iy,displacementmap_pars_vertex:Ly,displacementmap_vertex:Ny,emissivemap_fragment:Dy,emissivemap_pars_fragment:Uy,colorspace_fragment:Oy,colorspace_pars_fragment:Fy,envmap_fragment:ky,envmap_common_pars_fragment:By,envmap_pars_fragment:zy,envmap_pars_vertex:Vy,envmap_physical_pars_fragment:jy,envmap_vertex:Gy,fog_vertex:Hy,fog_pars_vertex:Wy,fog_fragment:Xy,fog_pars_fragment:$y,gradientmap_pars_fragment:qy,lightmap_pars_fragment:Yy,lights_lambert_fragment:Zy,lights_lambert_pars_fragment:Ky,lights_pars_begin:Jy,lights_toon_fragment:Qy,lights_toon_pars_fragment:tv,lights_phong_fragment:ev,lights_phong_pars_fragment:nv,lights_physical_fragment:iv,lights_physical_pars_fragment:sv,lights_fragment_begin:rv,lights_fragment_maps:ov,lights_fragment_end:av,lightprobes_pars_fragment:lv,logdepthbuf_fragment:cv,logdepthbuf_pars_fragment:hv,logdepthbuf_pars_vertex:uv,logdepthbuf_vertex:dv,map_fragment:fv,map_pars_fragment:pv,map_particle_fragment:mv,map_particle_pars_fragment:gv,metalnessmap_fragment:_v,metalnessmap_pars_fragment:xv,morphinstance_vertex:yv,morphcolor_vertex:vv,morphnormal_vertex:bv,morphtarget_pars_vertex:Sv,morphtarget_vertex:Mv,normal_fragment_begin:wv,normal_fragment_maps:Av,normal_pars_fragment:Tv,normal_pars_vertex:Ev,normal_vertex:Cv,normalmap_pars_fragment:Rv,clearcoat_normal_fragment_begin:Pv,clearcoat_normal_fragment_maps:Iv,clearcoat_pars_fragment:Lv,iridescence_pars_fragment:Nv,opaque_fragment:Dv,packing:Uv,premultiplied_alpha_fragment:Ov,project_vertex:Fv,dithering_fragment:kv,dithering_pars_fragment:Bv,roughnessmap_fragment:zv,roughnessmap_pars_fragment:Vv,shadowmap_pars_fragment:Gv,shadowmap_pars_vertex:Hv,shadowmap_vertex:Wv,shadowmask_pars_fragment:Xv,skinbase_vertex:$v,skinning_pars_vertex:qv,skinning_vertex:Yv,skinnormal_vertex:Zv,specularmap_fragment:Kv,specularmap_pars_fragment:Jv,tonemapping_fragment:jv,tonemapping_pars_fragment:Qv,transmission_fragment:tb,transmission_pars_fragment:eb,uv_pars_fragment:nb,uv_pars_vertex:ib,uv_vertex:sb,worldpos_vertex:rb,background_vert:ob,background_frag:ab,backgroundCube_vert:lb,backgroundCube_frag:cb,cube_vert:hb,cube_frag:ub,depth_vert:db,depth_frag:fb,distance_vert:pb,distance_frag:mb,equirect_vert:gb,equirect_frag:_b,linedashed_vert:xb,linedashed_frag:yb,meshbasic_vert:vb,meshbasic_frag:bb,meshlambert_vert:Sb,meshlambert_frag:Mb,meshmatcap_vert:wb,meshmatcap_frag:Ab,meshnormal_vert:Tb,meshnormal_frag:Eb,meshphong_vert:Cb,meshphong_frag:Rb,meshphysical_vert:Pb,meshphysical_frag:Ib,meshtoon_vert:Lb,meshtoon_frag:Nb,points_vert:Db,points_frag:Ub,shadow_vert:Ob,shadow_frag:Fb,sprite_vert:kb,sprite_frag:Bb},Lt={common:{diffuse:{value:new Qt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ee}},envmap:{envMap:{value:null},envMapRotation:{value:new ee},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ee}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ee}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ee},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ee},normalScale:{value:new Yt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ee},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ee}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ee}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ee}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Qt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Qt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0},uvTransform:{value:new ee}},sprite:{diffuse:{value:new Qt(16777215)},opacity:{value:1},center:{value:new Yt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}}},qi={basic:{uniforms:kn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.fog]),vertexShader:ce.meshbasic_vert,fragmentShader:ce.meshbasic_frag},lambert:{uniforms:kn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new Qt(0)},envMapIntensity:{value:1}}]),vertexShader:ce.meshlambert_vert,fragmentShader:ce.meshlambert_frag},phong:{uniforms:kn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new Qt(0)},specular:{value:new Qt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ce.meshphong_vert,fragmentShader:ce.meshphong_frag},standard:{uniforms:kn([Lt.common,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.roughnessmap,Lt.metalnessmap,Lt.fog,Lt.lights,{emissive:{value:new Qt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ce.meshphysical_vert,fragmentShader:ce.meshphysical_frag},toon:{uniforms:kn([Lt.common,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.gradientmap,Lt.fog,Lt.lights,{emissive:{value:new Qt(0)}}]),vertexShader:ce.meshtoon_vert,fragmentShader:ce.meshtoon_frag},matcap:{uniforms:kn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,{matcap:{value:null}}]),vertexShader:ce.meshmatcap_vert,fragmentShader:ce.meshmatcap_frag},points:{uniforms:kn([Lt.points,Lt.fog]),vertexShader:ce.points_vert,fragmentShader:ce.points_frag},dashed:{uniforms:kn([Lt.common,Lt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ce.linedashed_vert,fragmentShader:ce.linedashed_frag},depth:{uniforms:kn([Lt.common,Lt.displacementmap]),vertexShader:ce.depth_vert,fragmentShader:ce.depth_frag},normal:{uniforms:kn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,{opacity:{value:1}}]),vertexShader:ce.meshnormal_vert,fragmentShader:ce.meshnormal_frag},sprite:{uniforms:kn([Lt.sprite,Lt.fog]),vertexShader:ce.sprite_vert,fragmentShader:ce.sprite_frag},background:{uniforms:{uvTransform:{value:new ee},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ce.background_vert,fragmentShader:ce.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ee}},vertexShader:ce.backgroundCube_vert,fragmentShader:ce.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ce.cube_vert,fragmentShader:ce.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ce.equirect_vert,fragmentShader:ce.equirect_frag},distance:{uniforms:kn([Lt.common,Lt.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ce.distance_vert,fragmentShader:ce.distance_frag},shadow:{uniforms:kn([Lt.lights,Lt.fog,{color:{value:new Qt(0)},opacity:{value:1}}]),vertexShader:ce.shadow_vert,fragmentShader:ce.shadow_frag}};qi.physical={uniforms:kn([qi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ee},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ee},clearcoatNormalScale:{value:new Yt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ee},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ee},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ee},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ee},sheen:{value:0},sheenColor:{value:new Qt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ee},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ee},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ee},transmissionSamplerSize:{value:new Yt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ee},attenuationDistance:{value:0},attenuationColor:{value:new Qt(0)},specularColor:{value:new Qt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ee},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ee},anisotropyVector:{value:new Yt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ee}}]),vertexShader:ce.meshphysical_vert,fragmentShader:ce.meshphysical_frag};var Vc={r:0,b:0,g:0},zb=new pe,wm=new ee;wm.set(-1,0,0,0,1,0,0,0,1);function Vb(n,t,e,i,s,r){let o=new Qt(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(x){let A=x.isScene===!0?x.background:null;if(A&&A.isTexture){let b=x.backgroundBlurriness>0;A=t.get(A,b)}return A}function m(x){let A=!1,b=f(x);b===null?p(o,a):b&&b.isColor&&(p(b,1),A=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(x,A){let b=f(A);b&&b.isCubeTexture?(c===void 0&&(c=new Ln(new no(1,1,1),new Wi({name:"BackgroundCubeMaterial",uniforms:fr(qi.backgroundCube.uniforms),vertexShader:qi.backgroundCube.vertexShader,fragmentShader:qi.backgroundCube.fragmentShader,side:$n,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,M,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(zb.makeRotationFromEuler(A.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(wm),c.material.toneMapped=_e.getTransfer(b.colorSpace)!==Ae,(h!==b||u!==b.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,d=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Ln(new ca(2,2),new Wi({name:"BackgroundMaterial",uniforms:fr(qi.background.uniforms),vertexShader:qi.background.vertexShader,fragmentShader:qi.background.fragmentShader,side:Ws,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=_e.getTransfer(b.colorSpace)!==Ae,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,d=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function p(x,A){x.getRGB(Vc,Zu(n)),e.buffers.color.setClear(Vc.r,Vc.g,Vc.b,A,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,A=1){o.set(x),a=A,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,p(o,a)},render:m,addToRenderList:_,dispose:g}}function Gb(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(R,F,z,U,G){let q=!1,H=u(R,U,z,F);r!==H&&(r=H,c(r.object)),q=f(R,U,z,G),q&&m(R,U,z,G),G!==null&&t.update(G,n.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,b(R,F,z,U),G!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(G).buffer))}function l(){return n.createVertexArray()}function c(R){return n.bindVertexArray(R)}function h(R){return n.deleteVertexArray(R)}function u(R,F,z,U){let G=U.wireframe===!0,q=i[F.id];q===void 0&&(q={},i[F.id]=q);let H=R.isInstancedMesh===!0?R.id:0,lt=q[H];lt===void 0&&(lt={},q[H]=lt);let K=lt[z.id];K===void 0&&(K={},lt[z.id]=K);let Q=K[G];return Q===void 0&&(Q=d(l()),K[G]=Q),Q}function d(R){let F=[],z=[],U=[];for(let G=0;G<e;G++)F[G]=0,z[G]=0,U[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:F,enabledAttributes:z,attributeDivisors:U,object:R,attributes:{},index:null}}function f(R,F,z,U){let G=r.attributes,q=F.attributes,H=0,lt=z.getAttributes();for(let K in lt)if(lt[K].location>=0){let it=G[K],ft=q[K];if(ft===void 0&&(K==="instanceMatrix"&&R.instanceMatrix&&(ft=R.instanceMatrix),K==="instanceColor"&&R.instanceColor&&(ft=R.instanceColor)),it===void 0||it.attribute!==ft||ft&&it.data!==ft.data)return!0;H++}return r.attributesNum!==H||r.index!==U}function m(R,F,z,U){let G={},q=F.attributes,H=0,lt=z.getAttributes();for(let K in lt)if(lt[K].location>=0){let it=q[K];it===void 0&&(K==="instanceMatrix"&&R.instanceMatrix&&(it=R.instanceMatrix),K==="instanceColor"&&R.instanceColor&&(it=R.instanceColor));let ft={};ft.attribute=it,it&&it.data&&(ft.data=it.data),G[K]=ft,H++}r.attributes=G,r.attributesNum=H,r.index=U}function _(){let R=r.newAttributes;for(let F=0,z=R.length;F<z;F++)R[F]=0}function p(R){g(R,0)}function g(R,F){let z=r.newAttributes,U=r.enabledAttributes,G=r.attributeDivisors;z[R]=1,U[R]===0&&(n.enableVertexAttribArray(R),U[R]=1),G[R]!==F&&(n.vertexAttribDivisor(R,F),G[R]=F)}function x(){let R=r.newAttributes,F=r.enabledAttributes;for(let z=0,U=F.length;z<U;z++)F[z]!==R[z]&&(n.disableVertexAttribArray(z),F[z]=0)}function A(R,F,z,U,G,q,H){H===!0?n.vertexAttribIPointer(R,F,z,G,q):n.vertexAttribPointer(R,F,z,U,G,q)}function b(R,F,z,U){_();let G=U.attributes,q=z.getAttributes(),H=F.defaultAttributeValues;for(let lt in q){let K=q[lt];if(K.location>=0){let Q=G[lt];if(Q===void 0&&(lt==="instanceMatrix"&&R.instanceMatrix&&(Q=R.instanceMatrix),lt==="instanceColor"&&R.instanceColor&&(Q=R.instanceColor)),Q!==void 0){let it=Q.normalized,ft=Q.itemSize,dt=t.get(Q);if(dt===void 0)continue;let tt=dt.buffer,ut=dt.type,gt=dt.bytesPerElement,St=ut===n.INT||ut===n.UNSIGNED_INT||Q.gpuType===ic;if(Q.isInterleavedBufferAttribute){let Mt=Q.data,Ht=Mt.isInterleavedBuffer===!0?Mt.stride:Mt.itemSize,se=Q.offset;if(Mt.isInstancedInterleavedBuffer||Mt.isInstancedBufferAttribute){for(let Vt=0;Vt<K.locationSize;Vt++)g(K.location+Vt,Mt.meshPerAttribute);R.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=Mt.meshPerAttribute*Mt.count)}else for(let Vt=0;Vt<K.locationSize;Vt++)p(K.location+Vt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Vt=0;Vt<K.locationSize;Vt++)A(K.location+Vt,ft/K.locationSize,ut,it,Ht*gt,(se+ft/K.locationSize*Vt)*gt,St)}else{if(Q.isInstancedBufferAttribute){for(let Mt=0;Mt<K.locationSize;Mt++)g(K.location+Mt,Q.meshPerAttribute);R.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Mt=0;Mt<K.locationSize;Mt++)p(K.location+Mt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Mt=0;Mt<K.locationSize;Mt++)A(K.location+Mt,ft/K.locationSize,ut,it,ft*gt,ft/K.locationSize*Mt*gt,St)}}else if(H!==void 0){let it=H[lt];if(it!==void 0)switch(it.length){case 2:n.vertexAttrib2fv(K.location,it);break;case 3:n.vertexAttrib3fv(K.location,it);break;case 4:n.vertexAttrib4fv(K.location,it);break;default:n.vertexAttrib1fv(K.location,it)}}}}x()}function C(){P();for(let R in i){let F=i[R];for(let z in F){let U=F[z];for(let G in U){let q=U[G];for(let H in q)h(q[H].object),delete q[H];delete U[G]}}delete i[R]}}function M(R){if(i[R.id]===void 0)return;let F=i[R.id];for(let z in F){let U=F[z];for(let G in U){let q=U[G];for(let H in q)h(q[H].object),delete q[H];delete U[G]}}delete i[R.id]}function y(R){for(let F in i){let z=i[F];for(let U in z){let G=z[U];if(G[R.id]===void 0)continue;let q=G[R.id];for(let H in q)h(q[H].object),delete q[H];delete G[R.id]}}}function S(R){for(let F in i){let z=i[F],U=R.isInstancedMesh===!0?R.id:0,G=z[U];if(G!==void 0){for(let q in G){let H=G[q];for(let lt in H)h(H[lt].object),delete H[lt];delete G[q]}delete z[U],Object.keys(z).length===0&&delete i[F]}}}function P(){I(),o=!0,r!==s&&(r=s,c(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:P,resetDefaultState:I,dispose:C,releaseStatesOfGeometry:M,releaseStatesOfObject:S,releaseStatesOfProgram:y,initAttributes:_,enableAttribute:p,disableUnusedAttributes:x}}function Hb(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),e.update(c,i,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Wb(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Ri&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let S=y===Ci&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==Kn&&y!==_i&&!S&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&($t("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&$t("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&$t("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),M=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:m,maxTextureSize:_,maxCubemapSize:p,maxAttributes:g,maxVertexUniforms:x,maxVaryings:A,maxFragmentUniforms:b,maxSamples:C,samples:M}}function Xb(n){let t=this,e=null,i=0,s=!1,r=!1,o=new ri,a=new ee,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||i!==0||s;return s=d,i=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let m=u.clippingPlanes,_=u.clipIntersection,p=u.clipShadows,g=n.get(u);if(!s||m===null||m.length===0||r&&!p)r?h(null):c();else{let x=r?0:i,A=x*4,b=g.clippingState||null;l.value=b,b=h(m,d,A,f);for(let C=0;C!==A;++C)b[C]=e[C];g.clippingState=b,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(u,d,f,m){let _=u!==null?u.length:0,p=null;if(_!==0){if(p=l.value,m!==!0||p===null){let g=f+_*4,x=d.matrixWorldInverse;a.getNormalMatrix(x),(p===null||p.length<g)&&(p=new Float32Array(g));for(let A=0,b=f;A!==_;++A,b+=4)o.copy(u[A]).applyMatrix4(x,a),o.normal.toArray(p,b),p[b+3]=o.constant}l.value=p,l.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,p}}var Ra=class extends ai{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new ra(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new no(5,5,5),r=new Wi({name:"CubemapFromEquirect",uniforms:fr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:$n,blending:cr});r.uniforms.tEquirect.value=e;let o=new Ln(s,r),a=e.minFilter;return e.minFilter===ms&&(e.minFilter=Xn),new so(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},nm=256,$b=3,qb=20,Am=256,Tm=16,Yb=3,Zb=new X,Kb=new Qt,Hc=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new so(1,10,null),this._boxMesh=new Ln(new no(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=Zb}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,m=l.autoClearStencil,_=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(t.background=l.getClearColor(Kb));let p=new so(i,s,h);return p.position.copy(a),p.update(l,t),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=m,t.background=_,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=rm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=sm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(nm,$u(t))}_fromTexture(t,e){t.mapping===ur||t.mapping===lo?this._setSize(t.image.length===0?nm:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=im(t,!1,!1),i=Math.log2(t)-$b;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=im(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===ur||t.mapping===lo?(this._cubemapMaterial===null&&(this._cubemapMaterial=rm()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=sm()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Jb(),this._integrationMaterial=jb());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Tm);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-Yb)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Am*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Qb());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function im(n,t,e){return new Ra(n,{minFilter:ms,generateMipmaps:t,type:Ci,colorSpace:Ko,depthBuffer:e})}function Pa(n,t,e){return new Wi({name:n,uniforms:t,vertexShader:ce.cube_vert,fragmentShader:e,side:$n,blending:cr,depthTest:!1,depthWrite:!1})}function Jb(){return Pa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Am}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function jb(){return Pa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Tm}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Qb(){return Pa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${qb}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function sm(){return Pa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function rm(){return Pa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function tS(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===tc||f===ec)if(t.has(d)){let m=t.get(d).texture;return a(m,d.mapping)}else{let m=d.image;if(m&&m.height>0){let _=new Ra(m.height);return _.fromEquirectangularTexture(n,d),t.set(d,_),d.addEventListener("dispose",c),a(_.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,m=f===tc||f===ec,_=f===ur||f===lo;if(m||_){let p=e.get(d),g=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new Hc(n)),p=m?i.fromEquirectangular(d,p):i.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),p.texture;if(p!==void 0)return p.texture;{let x=d.image;return m&&x&&x.height>0||_&&x&&l(x)?(i===null&&(i=new Hc(n)),p=m?i.fromEquirectangular(d):i.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function a(d,f){return f===tc?d.mapping=ur:f===ec&&(d.mapping=lo),d}function l(d){let f=0,m=6;for(let _=0;_<m;_++)d[_]!==void 0&&f++;return f===m}function c(d){let f=d.target;f.removeEventListener("dispose",c);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function u(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:u}}function eS(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&$o("WebGLRenderer: "+i+" extension not supported."),s}}}function nS(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(let p in m.attributes)t.remove(m.attributes[p]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let _=r.get(m);_&&(t.remove(_),r.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),e.memory.geometries++),_}function h(m){let _=m.attributes;for(let p in _)t.update(_[p],n.ARRAY_BUFFER)}function u(m){let _=m.index,p=m.attributes.position,g=0;if(p===void 0)return;let x=_!==null?_.array.length:p.array.length/3-1,A=p.count>=65535?na:ea,b=new A(Math.ceil(x/3)*6,1),C=b.array;if(_!==null){let y=_.array;g=_.version;for(let S=0,P=0;S<x;S+=3){let I=y[S+0],R=y[S+1],F=y[S+2];C[P++]=I,C[P++]=R,C[P++]=R,C[P++]=F,C[P++]=F,C[P++]=I}}else{g=p.version;for(let y=0,S=0;y<x;y+=3){let P=y+0,I=y+1,R=y+2;C[S++]=P,C[S++]=I,C[S++]=I,C[S++]=R,C[S++]=R,C[S++]=P}}b.version=g;let M=r.get(m);M&&t.remove(M),r.set(m,b)}function d(m){let _=r.get(m);if(_){let p=m.index;p!==null&&_.version<p.version&&u(m)}else u(m);return r.get(m)}function f(){for(let m in s){let _=s[m].deref();_!==void 0&&l(_)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function iS(n,t,e){let i;function s(u){i=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){n.drawElements(i,d,r,u*o),e.update(d,i,1)}function c(u,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,u*o,f),e.update(d,i,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,u,0,f);let _=0;for(let p=0;p<f;p++)_+=d[p];e.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function sS(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:jt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function rS(n,t,e){let i=new WeakMap,s=new $e;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=i.get(a);if(d===void 0||d.count!==u){let P=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",P)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],A=0;f===!0&&(A=1),m===!0&&(A=2),_===!0&&(A=3);let b=a.attributes.position.count*A,C=1;b>t.maxTextureSize&&(C=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let M=new Float32Array(b*C*4*u),y=new Qo(M,b,C,u);y.type=_i,y.needsUpdate=!0;let S=A*4;for(let I=0;I<u;I++){let R=p[I],F=g[I],z=x[I],U=b*C*4*I;for(let G=0;G<R.count;G++){let q=G*S;f===!0&&(s.fromBufferAttribute(R,G),M[U+q+0]=s.x,M[U+q+1]=s.y,M[U+q+2]=s.z,M[U+q+3]=0),m===!0&&(s.fromBufferAttribute(F,G),M[U+q+4]=s.x,M[U+q+5]=s.y,M[U+q+6]=s.z,M[U+q+7]=0),_===!0&&(s.fromBufferAttribute(z,G),M[U+q+8]=s.x,M[U+q+9]=s.y,M[U+q+10]=s.z,M[U+q+11]=z.itemSize===4?s.w:1)}}d={count:u,texture:y,size:new Yt(b,C)},i.set(a,d),a.addEventListener("dispose",P)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let _=0;_<c.length;_++)f+=c[_];let m=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function oS(n,t,e,i,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=t.get(c,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var aS={[wu]:"LINEAR_TONE_MAPPING",[Au]:"REINHARD_TONE_MAPPING",[Tu]:"CINEON_TONE_MAPPING",[Eu]:"ACES_FILMIC_TONE_MAPPING",[Ru]:"AGX_TONE_MAPPING",[Pu]:"NEUTRAL_TONE_MAPPING",[Cu]:"CUSTOM_TONE_MAPPING"};function lS(n,t,e,i,s,r){let o=new ai(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new gn;h.setAttribute("position",new Qe([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Qe([0,2,0,0,2,0],2));let u=new kl({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Ln(h,u),f=new pa(-1,1,1,-1,0,1),m=null,_=null,p=!1,g,x=null,A=[],b=!1;this.setSize=function(C,M){o.setSize(C,M),a!==null&&a.setSize(C,M),l!==null&&l.setSize(C,M);for(let y=0;y<A.length;y++){let S=A[y];S.setSize&&S.setSize(C,M)}},this.setEffects=function(C){A=C,b=A.length>0&&A[0].isRenderPass===!0;let M=o.width,y=o.height;A.length>0&&a===null&&(a=new ai(M,y,{type:Ci,depthBuffer:!1,stencilBuffer:!1}),l=new ai(M,y,{type:Ci,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&A.some(P=>P.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&c===null&&(c=new fs(M,y),r===!0&&(c.format=gs,c.type=dr)),o.dispose(),o.depthTexture=S?c:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let P=0;P<A.length;P++){let I=A[P];I.setSize&&I.setSize(M,y),S&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(c)}},this.begin=function(C,M){if(p||C.toneMapping===Xi&&A.length===0)return!1;if(x=M,M!==null){let y=M.width,S=M.height;(o.width!==y||o.height!==S)&&this.setSize(y,S)}return b===!1&&C.setRenderTarget(o),g=C.toneMapping,C.toneMapping=Xi,!0},this.hasRenderPass=function(){return b},this.end=function(C,M){C.toneMapping=g,p=!0;let y=o,S=a;for(let P=0;P<A.length;P++){let I=A[P];I.enabled!==!1&&(I.render(C,S,y,M),I.needsSwap!==!1&&(y=S,S=S===a?l:a))}if(m!==C.outputColorSpace||_!==C.toneMapping){m=C.outputColorSpace,_=C.toneMapping,u.defines={},_e.getTransfer(m)===Ae&&(u.defines.SRGB_TRANSFER="");let P=aS[_];P&&(u.defines[P]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=y.texture,C.setRenderTarget(x),C.render(d,f),x=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Em=new Zn,Cm=new fs(1,1),Rm=new oa(1),Pm=new Qo,Im=new Nl,Lm=new ra,om=[],am=[],lm=new Float32Array(16),cm=new Float32Array(9),hm=new Float32Array(4);function fo(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=om[s];if(r===void 0&&(r=new Float32Array(s),om[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function _n(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function xn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Xc(n,t){let e=am[t];e===void 0&&(e=new Int32Array(t),am[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function cS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function hS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(_n(e,t))return;n.uniform2fv(this.addr,t),xn(e,t)}}function uS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(_n(e,t))return;n.uniform3fv(this.addr,t),xn(e,t)}}function dS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(_n(e,t))return;n.uniform4fv(this.addr,t),xn(e,t)}}function fS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(_n(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),xn(e,t)}else{if(_n(e,i))return;hm.set(i),n.uniformMatrix2fv(this.addr,!1,hm),xn(e,i)}}function pS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(_n(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),xn(e,t)}else{if(_n(e,i))return;cm.set(i),n.uniformMatrix3fv(this.addr,!1,cm),xn(e,i)}}function mS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(_n(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),xn(e,t)}else{if(_n(e,i))return;lm.set(i),n.uniformMatrix4fv(this.addr,!1,lm),xn(e,i)}}function gS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function _S(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(_n(e,t))return;n.uniform2iv(this.addr,t),xn(e,t)}}function xS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(_n(e,t))return;n.uniform3iv(this.addr,t),xn(e,t)}}function yS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(_n(e,t))return;n.uniform4iv(this.addr,t),xn(e,t)}}function vS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function bS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(_n(e,t))return;n.uniform2uiv(this.addr,t),xn(e,t)}}function SS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(_n(e,t))return;n.uniform3uiv(this.addr,t),xn(e,t)}}function MS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(_n(e,t))return;n.uniform4uiv(this.addr,t),xn(e,t)}}function $c(n){return n.version===0&&(n.compareFunction=Gu,n.needsUpdate=!0),n}function wS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=$c(Cm):r=Em,e.setTexture2D(t||r,s)}function AS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Im,s)}function TS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=$c(Rm):r=Lm,e.setTextureCube(t||r,s)}function ES(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Pm,s)}function CS(n){switch(n){case 5126:return cS;case 35664:return hS;case 35665:return uS;case 35666:return dS;case 35674:return fS;case 35675:return pS;case 35676:return mS;case 5124:case 35670:return gS;case 35667:case 35671:return _S;case 35668:case 35672:return xS;case 35669:case 35673:return yS;case 5125:return vS;case 36294:return bS;case 36295:return SS;case 36296:return MS;case 35678:case 36198:case 36298:case 36306:case 35682:return wS;case 35679:case 36299:case 36307:return AS;case 35680:case 36300:case 36308:case 36293:return TS;case 36289:case 36303:case 36311:case 36292:return ES}}function RS(n,t){n.uniform1fv(this.addr,t)}function PS(n,t){let e=fo(t,this.size,2);n.uniform2fv(this.addr,e)}function IS(n,t){let e=fo(t,this.size,3);n.uniform3fv(this.addr,e)}function LS(n,t){let e=fo(t,this.size,4);n.uniform4fv(this.addr,e)}function NS(n,t){let e=fo(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function DS(n,t){let e=fo(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function US(n,t){let e=fo(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function OS(n,t){n.uniform1iv(this.addr,t)}function FS(n,t){n.uniform2iv(this.addr,t)}function kS(n,t){n.uniform3iv(this.addr,t)}function BS(n,t){n.uniform4iv(this.addr,t)}function zS(n,t){n.uniform1uiv(this.addr,t)}function VS(n,t){n.uniform2uiv(this.addr,t)}function GS(n,t){n.uniform3uiv(this.addr,t)}function HS(n,t){n.uniform4uiv(this.addr,t)}function WS(n,t,e){let i=this.cache,s=t.length,r=Xc(e,s);_n(i,r)||(n.uniform1iv(this.addr,r),xn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=$c(Cm):o=Em;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function XS(n,t,e){let i=this.cache,s=t.length,r=Xc(e,s);_n(i,r)||(n.uniform1iv(this.addr,r),xn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Im,r[o])}function $S(n,t,e){let i=this.cache,s=t.length,r=Xc(e,s);_n(i,r)||(n.uniform1iv(this.addr,r),xn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=$c(Rm):o=Lm;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function qS(n,t,e){let i=this.cache,s=t.length,r=Xc(e,s);_n(i,r)||(n.uniform1iv(this.addr,r),xn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Pm,r[o])}function YS(n){switch(n){case 5126:return RS;case 35664:return PS;case 35665:return IS;case 35666:return LS;case 35674:return NS;case 35675:return DS;case 35676:return US;case 5124:case 35670:return OS;case 35667:case 35671:return FS;case 35668:case 35672:return kS;case 35669:case 35673:return BS;case 5125:return zS;case 36294:return VS;case 36295:return GS;case 36296:return HS;case 35678:case 36198:case 36298:case 36306:case 35682:return WS;case 35679:case 36299:case 36307:return XS;case 35680:case 36300:case 36308:case 36293:return $S;case 36289:case 36303:case 36311:case 36292:return qS}}var ed=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=CS(e.type)}},nd=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=YS(e.type)}},id=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Qu=/(\w+)(\])?(\[|\.)?/g;function um(n,t){n.seq.push(t),n.map[t.id]=t}function ZS(n,t,e){let i=n.name,s=i.length;for(Qu.lastIndex=0;;){let r=Qu.exec(i),o=Qu.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){um(e,c===void 0?new ed(a,n,t):new nd(a,n,t));break}else{let u=e.map[a];u===void 0&&(u=new id(a),um(e,u)),e=u}}}var uo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);ZS(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function dm(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var KS=37297,JS=0;function jS(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var fm=new ee;function QS(n){_e._getMatrix(fm,_e.workingColorSpace,n);let t=`mat3( ${fm.elements.map(e=>e.toFixed(4))} )`;switch(_e.getTransfer(n)){case Jo:return[t,"LinearTransferOETF"];case Ae:return[t,"sRGBTransferOETF"];default:return $t("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function pm(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+jS(n.getShaderSource(t),a)}else return r}function tM(n,t){let e=QS(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var eM={[wu]:"Linear",[Au]:"Reinhard",[Tu]:"Cineon",[Eu]:"ACESFilmic",[Ru]:"AgX",[Pu]:"Neutral",[Cu]:"Custom"};function nM(n,t){let e=eM[t];return e===void 0?($t("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Gc=new X;function iM(){_e.getLuminanceCoefficients(Gc);let n=Gc.x.toFixed(4),t=Gc.y.toFixed(4),e=Gc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function sM(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ca).join(`
`)}function rM(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function oM(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Ca(n){return n!==""}function mm(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function gm(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var aM=/^[ \t]*#include +<([\w\d./]+)>/gm;function sd(n){return n.replace(aM,lM)}function lM(n,t){let e=ce[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return sd(e)}var cM=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function _m(n){return n.replace(cM,hM)}function hM(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function xm(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var uM={[xa]:"SHADOWMAP_TYPE_PCF",[oo]:"SHADOWMAP_TYPE_VSM"};function dM(n){return uM[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var fM={[lo]:"ENVMAP_MODE_REFRACTION"};function pM(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":fM[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var mM={[Ql]:"ENVMAP_BLENDING_MULTIPLY",[Dp]:"ENVMAP_BLENDING_MIX",[Up]:"ENVMAP_BLENDING_ADD"};function gM(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":mM[n.combine]||"ENVMAP_BLENDING_NONE"}function _M(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=dM(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=pM(e),u=gM(e),d=sM(e),f=rM(r),m=s.createProgram(),_,p,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(_=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Ca).join(`
`),_.length>0&&(_+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Ca).join(`
`),p.length>0&&(p+=`
`)):(_=[xm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ca).join(`
`),p=[xm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Xi?"#define TONE_MAPPING":"",e.toneMapping!==Xi?ce.tonemapping_pars_fragment:"",e.toneMapping!==Xi?nM("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ce.colorspace_pars_fragment,tM("linearToOutputTexel",e.outputColorSpace),iM(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ca).join(`
`)),o=sd(o),o=mm(o,e),o=gm(o,e),a=sd(a),a=mm(a,e),a=gm(a,e),o=_m(o),a=_m(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,_=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,p=["#define varying in",e.glslVersion===Hu?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Hu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let x=g+_+o,A=g+p+a,b=dm(s,s.VERTEX_SHADER,x),C=dm(s,s.FRAGMENT_SHADER,A);s.attachShader(m,b),s.attachShader(m,C),e.index0AttributeName!==void 0?s.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function M(I){if(n.debug.checkShaderErrors){let R=s.getProgramInfoLog(m)||"",F=s.getShaderInfoLog(b)||"",z=s.getShaderInfoLog(C)||"",U=R.trim(),G=F.trim(),q=z.trim(),H=!0,lt=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,m,b,C);else{let K=pm(s,b,"vertex"),Q=pm(s,C,"fragment");jt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+U+`
`+K+`
`+Q)}else U!==""?$t("WebGLProgram: Program Info Log:",U):(G===""||q==="")&&(lt=!1);lt&&(I.diagnostics={runnable:H,programLog:U,vertexShader:{log:G,prefix:_},fragmentShader:{log:q,prefix:p}})}s.deleteShader(b),s.deleteShader(C),y=new uo(s,m),S=oM(s,m)}let y;this.getUniforms=function(){return y===void 0&&M(this),y};let S;this.getAttributes=function(){return S===void 0&&M(this),S};let P=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return P===!1&&(P=s.getProgramParameter(m,KS)),P},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=JS++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=b,this.fragmentShader=C,this}var xM=0,rd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new od(t),e.set(t,i)),i}},od=class{constructor(t){this.id=xM++,this.code=t,this.usedTimes=0}};function yM(n){return n===Xs||n===wa||n===Aa}function vM(n,t,e,i,s,r){let o=new to,a=new rd,l=new Set,c=[],h=new Map,u=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function m(y,S,P,I,R,F){let z=I.fog,U=R.geometry,G=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?I.environment:null,q=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,H=t.get(y.envMap||G,q),lt=d[y.type],K=i.precision;y.precision!==null&&(K=i.getMaxPrecision(y.precision),K!==y.precision&&$t("WebGLProgram.getParameters:",y.precision,"not supported, using",K,"instead."));let Q=U.morphAttributes.position||U.morphAttributes.normal||U.morphAttributes.color,it=Q!==void 0?Q.length:0,ft=0;U.morphAttributes.position!==void 0&&(ft=1),U.morphAttributes.normal!==void 0&&(ft=2),U.morphAttributes.color!==void 0&&(ft=3);let dt,tt,ut,gt;if(lt){let Ct=qi[lt];dt=Ct.vertexShader,tt=Ct.fragmentShader}else{dt=y.vertexShader,tt=y.fragmentShader;let Ct=a.getVertexShaderStage(y),oe=a.getFragmentShaderStage(y);a.update(y,Ct,oe),ut=Ct.id,gt=oe.id}let St=n.getRenderTarget(),Mt=n.state.buffers.depth.getReversed(),Ht=R.isInstancedMesh===!0,se=R.isBatchedMesh===!0,Vt=!!y.map,he=!!y.matcap,ae=!!H,ne=ae&&H.isPMREMTexture===!0,We=!!y.aoMap,Oe=!!y.lightMap,rn=!!y.bumpMap&&y.wireframe===!1,Ie=!!y.normalMap,Mn=!!y.displacementMap,ye=!!y.emissiveMap,pn=!!y.metalnessMap,Ye=!!y.roughnessMap,on=y.anisotropy>0,B=y.clearcoat>0,Rt=y.diffuseRoughness>0,qt=y.dispersion>0,re=y.retroreflectivity>0,wt=y.iridescence>0,Ne=y.sheen>0,zt=y.transmission>0,Xt=on&&!!y.anisotropyMap,L=B&&!!y.clearcoatMap,w=B&&!!y.clearcoatNormalMap,$=B&&!!y.clearcoatRoughnessMap,ht=Rt&&!!y.diffuseRoughnessMap,ot=wt&&!!y.iridescenceMap,xt=wt&&!!y.iridescenceThicknessMap,yt=Ne&&!!y.sheenColorMap,et=Ne&&!!y.sheenRoughnessMap,st=!!y.specularMap,mt=!!y.specularColorMap,k=!!y.specularIntensityMap,rt=zt&&!!y.transmissionMap,nt=zt&&!!y.thicknessMap,At=!!y.gradientMap,_t=!!y.alphaMap,bt=y.alphaTest>0,Gt=!!y.alphaHash,Kt=!!y.extensions,ct=Xi;y.toneMapped&&(St===null||St.isXRRenderTarget===!0)&&(ct=n.toneMapping);let Ft=ne?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,Jt={shaderID:lt,shaderType:y.type,shaderName:y.name,vertexShader:dt,fragmentShader:tt,defines:y.defines,customVertexShaderID:ut,customFragmentShaderID:gt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:K,batching:se,batchingColor:se&&R._colorsTexture!==null,instancing:Ht,instancingColor:Ht&&R.instanceColor!==null,instancingMorph:Ht&&R.morphTexture!==null,outputColorSpace:St===null?n.outputColorSpace:St.isXRRenderTarget===!0?St.texture.colorSpace:_e.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Vt,matcap:he,envMap:ae,envMapMode:ae&&H.mapping,envMapPMREM:ne,envMapMaxLod:ne?Ft.length-1:null,envMapSize:ne?Ft[0].width:null,aoMap:We,lightMap:Oe,bumpMap:rn,normalMap:Ie,displacementMap:Mn,emissiveMap:ye,normalMapObjectSpace:Ie&&y.normalMapType===kp,normalMapTangentSpace:Ie&&y.normalMapType===zc,packedNormalMap:Ie&&y.normalMapType===zc&&yM(y.normalMap.format),metalnessMap:pn,roughnessMap:Ye,anisotropy:on,anisotropyMap:Xt,clearcoat:B,clearcoatMap:L,clearcoatNormalMap:w,clearcoatRoughnessMap:$,diffuseRoughness:Rt,diffuseRoughnessMap:ht,dispersion:qt,retroreflection:re,iridescence:wt,iridescenceMap:ot,iridescenceThicknessMap:xt,sheen:Ne,sheenColorMap:yt,sheenRoughnessMap:et,specularMap:st,specularColorMap:mt,specularIntensityMap:k,transmission:zt,transmissionMap:rt,thicknessMap:nt,gradientMap:At,opaque:y.transparent===!1&&y.blending===ao&&y.alphaToCoverage===!1,alphaMap:_t,alphaTest:bt,alphaHash:Gt,combine:y.combine,mapUv:Vt&&f(y.map.channel),aoMapUv:We&&f(y.aoMap.channel),lightMapUv:Oe&&f(y.lightMap.channel),bumpMapUv:rn&&f(y.bumpMap.channel),normalMapUv:Ie&&f(y.normalMap.channel),displacementMapUv:Mn&&f(y.displacementMap.channel),emissiveMapUv:ye&&f(y.emissiveMap.channel),metalnessMapUv:pn&&f(y.metalnessMap.channel),roughnessMapUv:Ye&&f(y.roughnessMap.channel),anisotropyMapUv:Xt&&f(y.anisotropyMap.channel),clearcoatMapUv:L&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:w&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ht&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ot&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:xt&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:yt&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:et&&f(y.sheenRoughnessMap.channel),specularMapUv:st&&f(y.specularMap.channel),specularColorMapUv:mt&&f(y.specularColorMap.channel),specularIntensityMapUv:k&&f(y.specularIntensityMap.channel),transmissionMapUv:rt&&f(y.transmissionMap.channel),thicknessMapUv:nt&&f(y.thicknessMap.channel),alphaMapUv:_t&&f(y.alphaMap.channel),vertexTangents:!!U.attributes.tangent&&(Ie||on),vertexNormals:!!U.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!U.attributes.color&&U.attributes.color.itemSize===4,pointsUvs:R.isPoints===!0&&!!U.attributes.uv&&(Vt||_t),fog:!!z,useFog:y.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||U.attributes.normal===void 0&&Ie===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Mt,skinning:R.isSkinnedMesh===!0,hasPositionAttribute:U.attributes.position!==void 0,morphTargets:U.morphAttributes.position!==void 0,morphNormals:U.morphAttributes.normal!==void 0,morphColors:U.morphAttributes.color!==void 0,morphTargetsCount:it,morphTextureStride:ft,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:F.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&P.length>0,shadowMapType:n.shadowMap.type,toneMapping:ct,decodeVideoTexture:Vt&&y.map.isVideoTexture===!0&&_e.getTransfer(y.map.colorSpace)===Ae,decodeVideoTextureEmissive:ye&&y.emissiveMap.isVideoTexture===!0&&_e.getTransfer(y.emissiveMap.colorSpace)===Ae,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Fn,flipSided:y.side===$n,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Kt&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Kt&&y.extensions.multiDraw===!0||se)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return Jt.vertexUv1s=l.has(1),Jt.vertexUv2s=l.has(2),Jt.vertexUv3s=l.has(3),l.clear(),Jt}function _(y){let S=[];if(y.shaderID?S.push(y.shaderID):(S.push(y.customVertexShaderID),S.push(y.customFragmentShaderID)),y.defines!==void 0)for(let P in y.defines)S.push(P),S.push(y.defines[P]);return y.isRawShaderMaterial===!1&&(p(S,y),g(S,y),S.push(n.outputColorSpace)),S.push(y.customProgramCacheKey),S.join()}function p(y,S){y.push(S.precision),y.push(S.outputColorSpace),y.push(S.envMapMode),y.push(S.envMapPMREM),y.push(S.envMapMaxLod),y.push(S.envMapSize),y.push(S.mapUv),y.push(S.alphaMapUv),y.push(S.lightMapUv),y.push(S.aoMapUv),y.push(S.bumpMapUv),y.push(S.normalMapUv),y.push(S.displacementMapUv),y.push(S.emissiveMapUv),y.push(S.metalnessMapUv),y.push(S.roughnessMapUv),y.push(S.anisotropyMapUv),y.push(S.clearcoatMapUv),y.push(S.clearcoatNormalMapUv),y.push(S.clearcoatRoughnessMapUv),y.push(S.diffuseRoughnessMapUv),y.push(S.iridescenceMapUv),y.push(S.iridescenceThicknessMapUv),y.push(S.sheenColorMapUv),y.push(S.sheenRoughnessMapUv),y.push(S.specularMapUv),y.push(S.specularColorMapUv),y.push(S.specularIntensityMapUv),y.push(S.transmissionMapUv),y.push(S.thicknessMapUv),y.push(S.combine),y.push(S.fogExp2),y.push(S.sizeAttenuation),y.push(S.morphTargetsCount),y.push(S.numSunLights),y.push(S.numDirLights),y.push(S.numPointLights),y.push(S.numSpotLights),y.push(S.numSpotLightMaps),y.push(S.numHemiLights),y.push(S.numRectAreaLights),y.push(S.numSunLightShadows),y.push(S.numDirLightShadows),y.push(S.numPointLightShadows),y.push(S.numSpotLightShadows),y.push(S.numSpotLightShadowsWithMaps),y.push(S.numLightProbes),y.push(S.numLightProbeGrids),y.push(S.shadowMapType),y.push(S.toneMapping),y.push(S.numClippingPlanes),y.push(S.numClipIntersection),y.push(S.depthPacking)}function g(y,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function x(y){let S=d[y.type],P;if(S){let I=qi[S];P=Qp.clone(I.uniforms)}else P=y.uniforms;return P}function A(y,S){let P=h.get(S);return P!==void 0?++P.usedTimes:(P=new _M(n,S,y,s),c.push(P),h.set(S,P)),P}function b(y){if(--y.usedTimes===0){let S=c.indexOf(y);c[S]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function C(y){a.remove(y)}function M(){a.dispose()}return{getParameters:m,getProgramCacheKey:_,getUniforms:x,acquireProgram:A,releaseProgram:b,releaseShaderCache:C,programs:c,dispose:M}}function bM(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function SM(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function ym(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function vm(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,m,_,p,g){let x=n[t];return x===void 0?(x={id:d.id,object:d,geometry:f,material:m,materialVariant:o(d),groupOrder:_,renderOrder:d.renderOrder,z:p,group:g},n[t]=x):(x.id=d.id,x.object=d,x.geometry=f,x.material=m,x.materialVariant=o(d),x.groupOrder=_,x.renderOrder=d.renderOrder,x.z=p,x.group=g),t++,x}function l(d,f,m,_,p,g,x){x.reversedDepth===!0&&(p=-p);let A=a(d,f,m,_,p,g);m.transmission>0?i.push(A):m.transparent===!0?s.push(A):e.push(A)}function c(d,f,m,_,p,g){let x=a(d,f,m,_,p,g);m.transmission>0?i.unshift(x):m.transparent===!0?s.unshift(x):e.unshift(x)}function h(d,f){e.length>1&&e.sort(d||SM),i.length>1&&i.sort(f||ym),s.length>1&&s.sort(f||ym)}function u(){for(let d=t,f=n.length;d<f;d++){let m=n[d];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function MM(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new vm,n.set(i,[o])):s>=r.length?(o=new vm,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function wM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new X,color:new Qt};break;case"SpotLight":e={position:new X,direction:new X,color:new Qt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new X,color:new Qt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new X,skyColor:new Qt,groundColor:new Qt};break;case"RectAreaLight":e={color:new Qt,position:new X,halfWidth:new X,halfHeight:new X};break}return n[t.id]=e,e}}}function AM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var TM=0;function EM(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function CM(n){let t=new wM,e=AM(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new X);let s=new X,r=new pe,o=new pe;function a(c){let h=0,u=0,d=0;for(let F=0;F<9;F++)i.probe[F].set(0,0,0);let f=0,m=0,_=0,p=0,g=0,x=0,A=0,b=0,C=0,M=0,y=0,S=0,P=0,I=0;c.sort(EM);for(let F=0,z=c.length;F<z;F++){let U=c[F],G=U.color,q=U.intensity,H=U.distance,lt=null;if(U.shadow&&U.shadow.map&&(U.shadow.map.texture.format===Xs?lt=U.shadow.map.texture:lt=U.shadow.map.depthTexture||U.shadow.map.texture),U.isAmbientLight)h+=G.r*q,u+=G.g*q,d+=G.b*q;else if(U.isLightProbe){for(let K=0;K<9;K++)i.probe[K].addScaledVector(U.sh.coefficients[K],q);I++}else if(U.isSunLight){let K=t.get(U);if(K.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let Q=U.shadow,it=e.get(U);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[m]=it,i.sunShadowMap[m]=lt;let ft=Q.getViewportCount();for(let dt=0;dt<ft;dt++)i.sunShadowMatrix[_+dt]=Q.getMatrix(dt),i.sunShadowCascade[_+dt]=Q._cascadeData[dt];_+=ft,m++}i.sun[f]=K,f++}else if(U.isDirectionalLight){let K=t.get(U);if(K.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let Q=U.shadow,it=e.get(U);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,i.directionalShadow[p]=it,i.directionalShadowMap[p]=lt,i.directionalShadowMatrix[p]=U.shadow.matrix,C++}i.directional[p]=K,p++}else if(U.isSpotLight){let K=t.get(U);K.position.setFromMatrixPosition(U.matrixWorld),K.color.copy(G).multiplyScalar(q),K.distance=H,K.coneCos=Math.cos(U.angle),K.penumbraCos=Math.cos(U.angle*(1-U.penumbra)),K.decay=U.decay,i.spot[x]=K;let Q=U.shadow;if(U.map&&(i.spotLightMap[S]=U.map,S++,Q.updateMatrices(U),U.castShadow&&P++),i.spotLightMatrix[x]=Q.matrix,U.castShadow){let it=e.get(U);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,i.spotShadow[x]=it,i.spotShadowMap[x]=lt,y++}x++}else if(U.isRectAreaLight){let K=t.get(U);K.color.copy(G).multiplyScalar(q),K.halfWidth.set(U.width*.5,0,0),K.halfHeight.set(0,U.height*.5,0),i.rectArea[A]=K,A++}else if(U.isPointLight){let K=t.get(U);if(K.color.copy(U.color).multiplyScalar(U.intensity),K.distance=U.distance,K.decay=U.decay,U.castShadow){let Q=U.shadow,it=e.get(U);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,it.shadowCameraNear=Q.camera.near,it.shadowCameraFar=Q.camera.far,i.pointShadow[g]=it,i.pointShadowMap[g]=lt,i.pointShadowMatrix[g]=U.shadow.matrix,M++}i.point[g]=K,g++}else if(U.isHemisphereLight){let K=t.get(U);K.skyColor.copy(U.color).multiplyScalar(q),K.groundColor.copy(U.groundColor).multiplyScalar(q),i.hemi[b]=K,b++}}A>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Lt.LTC_FLOAT_1,i.rectAreaLTC2=Lt.LTC_FLOAT_2):(i.rectAreaLTC1=Lt.LTC_HALF_1,i.rectAreaLTC2=Lt.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=d;let R=i.hash;(R.sunLength!==f||R.directionalLength!==p||R.pointLength!==g||R.spotLength!==x||R.rectAreaLength!==A||R.hemiLength!==b||R.numSunShadows!==m||R.numDirectionalShadows!==C||R.numPointShadows!==M||R.numSpotShadows!==y||R.numSpotMaps!==S||R.numLightProbes!==I)&&(i.sun.length=f,i.directional.length=p,i.spot.length=x,i.rectArea.length=A,i.point.length=g,i.hemi.length=b,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=M,i.pointShadowMap.length=M,i.pointShadowMatrix.length=M,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+S-P,i.spotLightMap.length=S,i.numSpotLightShadowsWithMaps=P,i.numLightProbes=I,R.sunLength=f,R.directionalLength=p,R.pointLength=g,R.spotLength=x,R.rectAreaLength=A,R.hemiLength=b,R.numSunShadows=m,R.numDirectionalShadows=C,R.numPointShadows=M,R.numSpotShadows=y,R.numSpotMaps=S,R.numLightProbes=I,i.version=TM++)}function l(c,h){let u=0,d=0,f=0,m=0,_=0,p=0,g=h.matrixWorldInverse;for(let x=0,A=c.length;x<A;x++){let b=c[x];if(b.isSunLight){let C=i.sun[u];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(g),u++}else if(b.isDirectionalLight){let C=i.directional[d];C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),d++}else if(b.isSpotLight){let C=i.spot[m];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),m++}else if(b.isRectAreaLight){let C=i.rectArea[_];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),o.identity(),r.copy(b.matrixWorld),r.premultiply(g),o.extractRotation(r),C.halfWidth.set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),_++}else if(b.isPointLight){let C=i.point[f];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let C=i.hemi[p];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(g),p++}}}return{setup:a,setupView:l,state:i}}function bm(n){let t=new CM(n),e=[],i=[],s=[];function r(u){h.camera=u,e.length=0,i.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){i.push(u)}function l(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function RM(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new bm(n),t.set(s,[a])):r>=o.length?(a=new bm(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var PM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,IM=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,LM=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],NM=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],Sm=new pe,Ea=new X,td=new X;function DM(n,t,e){let i=new Fs,s=new Yt,r=new Yt,o=new $e,a=new Bl,l=new zl,c={},h=e.maxTextureSize,u={[Ws]:$n,[$n]:Ws,[Fn]:Fn},d=new Wi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Yt},radius:{value:4}},vertexShader:PM,fragmentShader:IM}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let m=new gn;m.setAttribute("position",new nn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Ln(m,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=xa;let g=this.type;this.render=function(M,y,S){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||M.length===0)return;this.type===mp&&($t("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=xa);let P=n.getRenderTarget(),I=n.getActiveCubeFace(),R=n.getActiveMipmapLevel(),F=n.state;F.setBlending(cr),F.buffers.depth.getReversed()===!0?F.buffers.color.setClear(0,0,0,0):F.buffers.color.setClear(1,1,1,1),F.buffers.depth.setTest(!0),F.setScissorTest(!1);let z=g!==this.type;z&&y.traverse(function(U){U.material&&(Array.isArray(U.material)?U.material.forEach(G=>G.needsUpdate=!0):U.material.needsUpdate=!0)});for(let U=0,G=M.length;U<G;U++){let q=M[U],H=q.shadow;if(H===void 0){$t("WebGLShadowMap:",q,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let lt=H.getFrameExtents();s.multiply(lt),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/lt.x),s.x=r.x*lt.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/lt.y),s.y=r.y*lt.y,H.mapSize.y=r.y));let K=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=K,H.map===null||z===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===oo){if(q.isPointLight){$t("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new ai(s.x,s.y,{format:Xs,type:Ci,minFilter:Xn,magFilter:Xn,generateMipmaps:!1}),H.map.texture.name=q.name+".shadowMap",H.map.depthTexture=new fs(s.x,s.y,_i),H.map.depthTexture.name=q.name+".shadowMapDepth",H.map.depthTexture.format=cs,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Rn,H.map.depthTexture.magFilter=Rn}else q.isPointLight?(H.map=new Ra(s.x),H.map.depthTexture=new oa(s.x,Ei)):(H.map=new ai(s.x,s.y),H.map.depthTexture=new fs(s.x,s.y,Ei)),H.map.depthTexture.name=q.name+".shadowMap",H.map.depthTexture.format=cs,this.type===xa?(H.map.depthTexture.compareFunction=K?Vu:zu,H.map.depthTexture.minFilter=Xn,H.map.depthTexture.magFilter=Xn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Rn,H.map.depthTexture.magFilter=Rn);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let Q=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();q.isPointLight!==!0&&H.updateMatrices(q,S);let it=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:S.layers;for(let ft=0;ft<Q;ft++){let dt=H.getCamera(ft);if(q.isPointLight){let tt=H.camera,ut=H.matrix,gt=q.distance||tt.far;gt!==tt.far&&(tt.far=gt,tt.updateProjectionMatrix()),Ea.setFromMatrixPosition(q.matrixWorld),tt.position.copy(Ea),td.copy(tt.position),td.add(LM[ft]),tt.up.copy(NM[ft]),tt.lookAt(td),tt.updateMatrixWorld(),ut.makeTranslation(-Ea.x,-Ea.y,-Ea.z),Sm.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Sm,tt.coordinateSystem,tt.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,ft),n.clear();else{ft===0&&(n.setRenderTarget(H.map),n.clear());let tt=H.getViewport(ft);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),F.viewport(o)}i=H.getFrustum(ft),b(y,S,dt,q,it,this.type)}H.isPointLightShadow!==!0&&this.type===oo&&x(H,S),H.needsUpdate=!1}g=this.type,p.needsUpdate=!1,n.setRenderTarget(P,I,R)};function x(M,y){let S=t.update(_);d.defines.VSM_SAMPLES!==M.blurSamples&&(d.defines.VSM_SAMPLES=M.blurSamples,f.defines.VSM_SAMPLES=M.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),M.mapPass===null?M.mapPass=new ai(s.x,s.y,{format:Xs,type:Ci}):(M.mapPass.width!==M.map.width||M.mapPass.height!==M.map.height)&&M.mapPass.setSize(M.map.width,M.map.height),d.uniforms.shadow_pass.value=M.map.depthTexture,d.uniforms.resolution.value.set(M.map.width,M.map.height),d.uniforms.radius.value=M.radius,n.setRenderTarget(M.mapPass),n.clear(),n.renderBufferDirect(y,null,S,d,_,null),f.uniforms.shadow_pass.value=M.mapPass.texture,f.uniforms.resolution.value.set(M.map.width,M.map.height),f.uniforms.radius.value=M.radius,n.setRenderTarget(M.map),n.clear(),n.renderBufferDirect(y,null,S,f,_,null)}function A(M,y,S,P){let I=null,R=S.isPointLight===!0?M.customDistanceMaterial:M.customDepthMaterial;if(R!==void 0)I=R;else if(I=S.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let F=I.uuid,z=y.uuid,U=c[F];U===void 0&&(U={},c[F]=U);let G=U[z];G===void 0&&(G=I.clone(),U[z]=G,y.addEventListener("dispose",C)),I=G}if(I.visible=y.visible,I.wireframe=y.wireframe,P===oo?I.side=y.shadowSide!==null?y.shadowSide:y.side:I.side=y.shadowSide!==null?y.shadowSide:u[y.side],I.alphaMap=y.alphaMap,I.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,I.map=y.map,I.clipShadows=y.clipShadows,I.clippingPlanes=y.clippingPlanes,I.clipIntersection=y.clipIntersection,I.displacementMap=y.displacementMap,I.displacementScale=y.displacementScale,I.displacementBias=y.displacementBias,I.wireframeLinewidth=y.wireframeLinewidth,I.linewidth=y.linewidth,S.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let F=n.properties.get(I);F.light=S}return I}function b(M,y,S,P,I,R){if(M.visible===!1)return;if(M.layers.test(I)&&(M.isMesh||M.isLine||M.isPoints)&&(M.castShadow||M.receiveShadow&&R===oo)&&(!M.frustumCulled||M.intersectsFrustum(i))){M.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,M.matrixWorld);let U=t.update(M),G=M.material;if(Array.isArray(G)){let q=U.groups;for(let H=0,lt=q.length;H<lt;H++){let K=q[H],Q=G[K.materialIndex];if(Q&&Q.visible){let it=A(M,Q,P,R);M.onBeforeShadow(n,M,y,S,U,it,K),n.renderBufferDirect(S,null,U,it,M,K),M.onAfterShadow(n,M,y,S,U,it,K)}}}else if(G.visible){let q=A(M,G,P,R);M.onBeforeShadow(n,M,y,S,U,q,null),n.renderBufferDirect(S,null,U,q,M,null),M.onAfterShadow(n,M,y,S,U,q,null)}}let z=M.children;for(let U=0,G=z.length;U<G;U++)b(z[U],y,S,P,I,R)}function C(M){M.target.removeEventListener("dispose",C);for(let S in c){let P=c[S],I=M.target.uuid;I in P&&(P[I].dispose(),delete P[I])}}}function UM(n,t){function e(){let k=!1,rt=new $e,nt=null,At=new $e(0,0,0,0);return{setMask:function(_t){nt!==_t&&!k&&(n.colorMask(_t,_t,_t,_t),nt=_t)},setLocked:function(_t){k=_t},setClear:function(_t,bt,Gt,Kt,ct){ct===!0&&(_t*=Kt,bt*=Kt,Gt*=Kt),rt.set(_t,bt,Gt,Kt),At.equals(rt)===!1&&(n.clearColor(_t,bt,Gt,Kt),At.copy(rt))},reset:function(){k=!1,nt=null,At.set(-1,0,0,0)}}}function i(){let k=!1,rt=!1,nt=null,At=null,_t=null;return{setReversed:function(bt){if(rt!==bt){let Gt=t.get("EXT_clip_control");bt?Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.ZERO_TO_ONE_EXT):Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.NEGATIVE_ONE_TO_ONE_EXT),rt=bt;let Kt=_t;_t=null,this.setClear(Kt)}},getReversed:function(){return rt},setTest:function(bt){bt?Mt(n.DEPTH_TEST):Ht(n.DEPTH_TEST)},setMask:function(bt){nt!==bt&&!k&&(n.depthMask(bt),nt=bt)},setFunc:function(bt){if(rt&&(bt=Zp[bt]),At!==bt){switch(bt){case bl:n.depthFunc(n.NEVER);break;case Sl:n.depthFunc(n.ALWAYS);break;case Ml:n.depthFunc(n.LESS);break;case Zr:n.depthFunc(n.LEQUAL);break;case wl:n.depthFunc(n.EQUAL);break;case Al:n.depthFunc(n.GEQUAL);break;case Tl:n.depthFunc(n.GREATER);break;case El:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}At=bt}},setLocked:function(bt){k=bt},setClear:function(bt){_t!==bt&&(_t=bt,rt&&(bt=1-bt),n.clearDepth(bt))},reset:function(){k=!1,nt=null,At=null,_t=null,rt=!1}}}function s(){let k=!1,rt=null,nt=null,At=null,_t=null,bt=null,Gt=null,Kt=null,ct=null;return{setTest:function(Ft){k||(Ft?Mt(n.STENCIL_TEST):Ht(n.STENCIL_TEST))},setMask:function(Ft){rt!==Ft&&!k&&(n.stencilMask(Ft),rt=Ft)},setFunc:function(Ft,Jt,Ct){(nt!==Ft||At!==Jt||_t!==Ct)&&(n.stencilFunc(Ft,Jt,Ct),nt=Ft,At=Jt,_t=Ct)},setOp:function(Ft,Jt,Ct){(bt!==Ft||Gt!==Jt||Kt!==Ct)&&(n.stencilOp(Ft,Jt,Ct),bt=Ft,Gt=Jt,Kt=Ct)},setLocked:function(Ft){k=Ft},setClear:function(Ft){ct!==Ft&&(n.clearStencil(Ft),ct=Ft)},reset:function(){k=!1,rt=null,nt=null,At=null,_t=null,bt=null,Gt=null,Kt=null,ct=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,m=[],_=null,p=!1,g=null,x=null,A=null,b=null,C=null,M=null,y=null,S=new Qt(0,0,0),P=0,I=!1,R=null,F=null,z=null,U=null,G=null,q=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,lt=0,K=n.getParameter(n.VERSION);K.indexOf("WebGL")!==-1?(lt=parseFloat(/^WebGL (\d)/.exec(K)[1]),H=lt>=1):K.indexOf("OpenGL ES")!==-1&&(lt=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),H=lt>=2);let Q=null,it={},ft=n.getParameter(n.SCISSOR_BOX),dt=n.getParameter(n.VIEWPORT),tt=new $e().fromArray(ft),ut=new $e().fromArray(dt);function gt(k,rt,nt,At){let _t=new Uint8Array(4),bt=n.createTexture();n.bindTexture(k,bt),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Gt=0;Gt<nt;Gt++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(rt,0,n.RGBA,1,1,At,0,n.RGBA,n.UNSIGNED_BYTE,_t):n.texImage2D(rt+Gt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_t);return bt}let St={};St[n.TEXTURE_2D]=gt(n.TEXTURE_2D,n.TEXTURE_2D,1),St[n.TEXTURE_CUBE_MAP]=gt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),St[n.TEXTURE_2D_ARRAY]=gt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),St[n.TEXTURE_3D]=gt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Mt(n.DEPTH_TEST),o.setFunc(Zr),rn(!1),Ie(xu),Mt(n.CULL_FACE),We(cr);function Mt(k){h[k]!==!0&&(n.enable(k),h[k]=!0)}function Ht(k){h[k]!==!1&&(n.disable(k),h[k]=!1)}function se(k,rt){return d[k]!==rt?(n.bindFramebuffer(k,rt),d[k]=rt,k===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=rt),k===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=rt),!0):!1}function Vt(k,rt){let nt=m,At=!1;if(k){nt=f.get(rt),nt===void 0&&(nt=[],f.set(rt,nt));let _t=k.textures;if(nt.length!==_t.length||nt[0]!==n.COLOR_ATTACHMENT0){for(let bt=0,Gt=_t.length;bt<Gt;bt++)nt[bt]=n.COLOR_ATTACHMENT0+bt;nt.length=_t.length,At=!0}}else nt[0]!==n.BACK&&(nt[0]=n.BACK,At=!0);At&&n.drawBuffers(nt)}function he(k){return _!==k?(n.useProgram(k),_=k,!0):!1}let ae={[hr]:n.FUNC_ADD,[_p]:n.FUNC_SUBTRACT,[xp]:n.FUNC_REVERSE_SUBTRACT};ae[yp]=n.MIN,ae[vp]=n.MAX;let ne={[bp]:n.ZERO,[Sp]:n.ONE,[Mp]:n.SRC_COLOR,[Su]:n.SRC_ALPHA,[Rp]:n.SRC_ALPHA_SATURATE,[Ep]:n.DST_COLOR,[Ap]:n.DST_ALPHA,[wp]:n.ONE_MINUS_SRC_COLOR,[Mu]:n.ONE_MINUS_SRC_ALPHA,[Cp]:n.ONE_MINUS_DST_COLOR,[Tp]:n.ONE_MINUS_DST_ALPHA,[Pp]:n.CONSTANT_COLOR,[Ip]:n.ONE_MINUS_CONSTANT_COLOR,[Lp]:n.CONSTANT_ALPHA,[Np]:n.ONE_MINUS_CONSTANT_ALPHA};function We(k,rt,nt,At,_t,bt,Gt,Kt,ct,Ft){if(k===cr){p===!0&&(Ht(n.BLEND),p=!1);return}if(p===!1&&(Mt(n.BLEND),p=!0),k!==gp){if(k!==g||Ft!==I){if((x!==hr||C!==hr)&&(n.blendEquation(n.FUNC_ADD),x=hr,C=hr),Ft)switch(k){case ao:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case yu:n.blendFunc(n.ONE,n.ONE);break;case vu:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case bu:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:jt("WebGLState: Invalid blending: ",k);break}else switch(k){case ao:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case yu:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case vu:jt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case bu:jt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:jt("WebGLState: Invalid blending: ",k);break}A=null,b=null,M=null,y=null,S.set(0,0,0),P=0,g=k,I=Ft}return}_t=_t||rt,bt=bt||nt,Gt=Gt||At,(rt!==x||_t!==C)&&(n.blendEquationSeparate(ae[rt],ae[_t]),x=rt,C=_t),(nt!==A||At!==b||bt!==M||Gt!==y)&&(n.blendFuncSeparate(ne[nt],ne[At],ne[bt],ne[Gt]),A=nt,b=At,M=bt,y=Gt),(Kt.equals(S)===!1||ct!==P)&&(n.blendColor(Kt.r,Kt.g,Kt.b,ct),S.copy(Kt),P=ct),g=k,I=!1}function Oe(k,rt){k.side===Fn?Ht(n.CULL_FACE):Mt(n.CULL_FACE);let nt=k.side===$n;rt&&(nt=!nt),rn(nt),k.blending===ao&&k.transparent===!1?We(cr):We(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let At=k.stencilWrite;a.setTest(At),At&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),ye(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?Mt(n.SAMPLE_ALPHA_TO_COVERAGE):Ht(n.SAMPLE_ALPHA_TO_COVERAGE)}function rn(k){R!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),R=k)}function Ie(k){k!==fp?(Mt(n.CULL_FACE),k!==F&&(k===xu?n.cullFace(n.BACK):k===pp?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ht(n.CULL_FACE),F=k}function Mn(k){k!==z&&(H&&n.lineWidth(k),z=k)}function ye(k,rt,nt){k?(Mt(n.POLYGON_OFFSET_FILL),(U!==rt||G!==nt)&&(U=rt,G=nt,o.getReversed()&&(rt=-rt,nt=-nt),n.polygonOffset(rt,nt))):Ht(n.POLYGON_OFFSET_FILL)}function pn(k){k?Mt(n.SCISSOR_TEST):Ht(n.SCISSOR_TEST)}function Ye(k){k===void 0&&(k=n.TEXTURE0+q-1),Q!==k&&(n.activeTexture(k),Q=k)}function on(k,rt,nt){nt===void 0&&(Q===null?nt=n.TEXTURE0+q-1:nt=Q);let At=it[nt];At===void 0&&(At={type:void 0,texture:void 0},it[nt]=At),(At.type!==k||At.texture!==rt)&&(Q!==nt&&(n.activeTexture(nt),Q=nt),n.bindTexture(k,rt||St[k]),At.type=k,At.texture=rt)}function B(){let k=it[Q];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Rt(){try{n.compressedTexImage2D(...arguments)}catch(k){jt("WebGLState:",k)}}function qt(){try{n.compressedTexImage3D(...arguments)}catch(k){jt("WebGLState:",k)}}function re(){try{n.texSubImage2D(...arguments)}catch(k){jt("WebGLState:",k)}}function wt(){try{n.texSubImage3D(...arguments)}catch(k){jt("WebGLState:",k)}}function Ne(){try{n.compressedTexSubImage2D(...arguments)}catch(k){jt("WebGLState:",k)}}function zt(){try{n.compressedTexSubImage3D(...arguments)}catch(k){jt("WebGLState:",k)}}function Xt(){try{n.texStorage2D(...arguments)}catch(k){jt("WebGLState:",k)}}function L(){try{n.texStorage3D(...arguments)}catch(k){jt("WebGLState:",k)}}function w(){try{n.texImage2D(...arguments)}catch(k){jt("WebGLState:",k)}}function $(){try{n.texImage3D(...arguments)}catch(k){jt("WebGLState:",k)}}function ht(k){return u[k]!==void 0?u[k]:n.getParameter(k)}function ot(k,rt){u[k]!==rt&&(n.pixelStorei(k,rt),u[k]=rt)}function xt(k){tt.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),tt.copy(k))}function yt(k){ut.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),ut.copy(k))}function et(k,rt){let nt=c.get(rt);nt===void 0&&(nt=new WeakMap,c.set(rt,nt));let At=nt.get(k);At===void 0&&(At=n.getUniformBlockIndex(rt,k.name),n.uniformBlockBinding(rt,At,At),nt.set(k,At))}function st(k,rt,nt){let _t=c.get(rt).get(k);l[_t]!==nt&&(n.bindBufferBase(n.UNIFORM_BUFFER,_t,nt),l[_t]=nt)}function mt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,it={},d={},l={},f=new WeakMap,m=[],_=null,p=!1,g=null,x=null,A=null,b=null,C=null,M=null,y=null,S=new Qt(0,0,0),P=0,I=!1,R=null,F=null,z=null,U=null,G=null,tt.set(0,0,n.canvas.width,n.canvas.height),ut.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Mt,disable:Ht,bindFramebuffer:se,drawBuffers:Vt,useProgram:he,setBlending:We,setMaterial:Oe,setFlipSided:rn,setCullFace:Ie,setLineWidth:Mn,setPolygonOffset:ye,setScissorTest:pn,activeTexture:Ye,bindTexture:on,unbindTexture:B,compressedTexImage2D:Rt,compressedTexImage3D:qt,texImage2D:w,texImage3D:$,pixelStorei:ot,getParameter:ht,updateUBOMapping:et,uniformBlockBinding:st,texStorage2D:Xt,texStorage3D:L,texSubImage2D:re,texSubImage3D:wt,compressedTexSubImage2D:Ne,compressedTexSubImage3D:zt,scissor:xt,viewport:yt,reset:mt}}function OM(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Yt,h=new WeakMap,u=new Set,d,f=new WeakMap,m=new Set,_=new FinalizationRegistry(L=>m.delete(L)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(L,w){return p?new OffscreenCanvas(L,w):jo("canvas")}function x(L,w,$){let ht=1,ot=Xt(L);if((ot.width>$||ot.height>$)&&(ht=$/Math.max(ot.width,ot.height)),ht<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let xt=Math.floor(ht*ot.width),yt=Math.floor(ht*ot.height);d===void 0&&(d=g(xt,yt));let et=w?g(xt,yt):d;return et.width=xt,et.height=yt,et.getContext("2d").drawImage(L,0,0,xt,yt),$t("WebGLRenderer: Texture has been resized from ("+ot.width+"x"+ot.height+") to ("+xt+"x"+yt+")."),et}else return"data"in L&&$t("WebGLRenderer: Image in DataTexture is too big ("+ot.width+"x"+ot.height+")."),L;return L}function A(L){return L.generateMipmaps}function b(L){n.generateMipmap(L)}function C(L){return L.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?n.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function M(L,w,$,ht,ot,xt=!1){if(L!==null){if(n[L]!==void 0)return n[L];$t("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let yt;ht&&(yt=t.get("EXT_texture_norm16"),yt||$t("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=w;if(w===n.RED&&($===n.FLOAT&&(et=n.R32F),$===n.HALF_FLOAT&&(et=n.R16F),$===n.UNSIGNED_BYTE&&(et=n.R8),$===n.UNSIGNED_SHORT&&yt&&(et=yt.R16_EXT),$===n.SHORT&&yt&&(et=yt.R16_SNORM_EXT)),w===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(et=n.R8UI),$===n.UNSIGNED_SHORT&&(et=n.R16UI),$===n.UNSIGNED_INT&&(et=n.R32UI),$===n.BYTE&&(et=n.R8I),$===n.SHORT&&(et=n.R16I),$===n.INT&&(et=n.R32I)),w===n.RG&&($===n.FLOAT&&(et=n.RG32F),$===n.HALF_FLOAT&&(et=n.RG16F),$===n.UNSIGNED_BYTE&&(et=n.RG8),$===n.UNSIGNED_SHORT&&yt&&(et=yt.RG16_EXT),$===n.SHORT&&yt&&(et=yt.RG16_SNORM_EXT)),w===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(et=n.RG8UI),$===n.UNSIGNED_SHORT&&(et=n.RG16UI),$===n.UNSIGNED_INT&&(et=n.RG32UI),$===n.BYTE&&(et=n.RG8I),$===n.SHORT&&(et=n.RG16I),$===n.INT&&(et=n.RG32I)),w===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(et=n.RGB8UI),$===n.UNSIGNED_SHORT&&(et=n.RGB16UI),$===n.UNSIGNED_INT&&(et=n.RGB32UI),$===n.BYTE&&(et=n.RGB8I),$===n.SHORT&&(et=n.RGB16I),$===n.INT&&(et=n.RGB32I)),w===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(et=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(et=n.RGBA16UI),$===n.UNSIGNED_INT&&(et=n.RGBA32UI),$===n.BYTE&&(et=n.RGBA8I),$===n.SHORT&&(et=n.RGBA16I),$===n.INT&&(et=n.RGBA32I)),w===n.RGB&&($===n.UNSIGNED_SHORT&&yt&&(et=yt.RGB16_EXT),$===n.SHORT&&yt&&(et=yt.RGB16_SNORM_EXT),$===n.UNSIGNED_INT_5_9_9_9_REV&&(et=n.RGB9_E5),$===n.UNSIGNED_INT_10F_11F_11F_REV&&(et=n.R11F_G11F_B10F)),w===n.RGBA){let st=xt?Jo:_e.getTransfer(ot);$===n.FLOAT&&(et=n.RGBA32F),$===n.HALF_FLOAT&&(et=n.RGBA16F),$===n.UNSIGNED_BYTE&&(et=st===Ae?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT&&yt&&(et=yt.RGBA16_EXT),$===n.SHORT&&yt&&(et=yt.RGBA16_SNORM_EXT),$===n.UNSIGNED_SHORT_4_4_4_4&&(et=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(et=n.RGB5_A1)}return(et===n.R16F||et===n.R32F||et===n.RG16F||et===n.RG32F||et===n.RGBA16F||et===n.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function y(L,w){let $;return L?w===null||w===Ei||w===dr?$=n.DEPTH24_STENCIL8:w===_i?$=n.DEPTH32F_STENCIL8:w===co&&($=n.DEPTH24_STENCIL8,$t("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Ei||w===dr?$=n.DEPTH_COMPONENT24:w===_i?$=n.DEPTH_COMPONENT32F:w===co&&($=n.DEPTH_COMPONENT16),$}function S(L,w){return A(L)===!0||L.isFramebufferTexture&&L.minFilter!==Rn&&L.minFilter!==Xn?Math.log2(Math.max(w.width,w.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?w.mipmaps.length:1}function P(L){let w=new WeakRef(L);i.get(L).__ref=w,m.add(w),_.register(L,w,w)}function I(L){let w=i.get(L).__ref;w!==void 0&&(m.delete(w),_.unregister(w))}function R(L){z(L.target)}function F(L){U(L.target)}function z(L){L.removeEventListener("dispose",R),I(L),q(L),L.isVideoTexture&&h.delete(L),L.isHTMLTexture&&u.delete(L)}function U(L){L.removeEventListener("dispose",F),I(L),lt(L)}function G(){for(let L of m){let w=L.deref();w!==void 0&&(w.isRenderTarget===!0?U(w):z(w))}m.clear(),u.clear()}function q(L){let w=i.get(L);if(w.__webglInit===void 0)return;let $=L.source,ht=f.get($);if(ht){let ot=ht[w.__cacheKey];ot.usedTimes--,ot.usedTimes===0&&H(L),Object.keys(ht).length===0&&f.delete($)}i.remove(L)}function H(L){let w=i.get(L);n.deleteTexture(w.__webglTexture);let $=L.source,ht=f.get($);delete ht[w.__cacheKey],o.memory.textures--}function lt(L){let w=i.get(L);w.__depthDisposeCallback&&w.__depthDisposeCallback();let $=L.depthTexture;if($&&$.renderTarget===L&&z($),L.isWebGLCubeRenderTarget)for(let ot=0;ot<6;ot++){if(Array.isArray(w.__webglFramebuffer[ot]))for(let xt=0;xt<w.__webglFramebuffer[ot].length;xt++)n.deleteFramebuffer(w.__webglFramebuffer[ot][xt]);else n.deleteFramebuffer(w.__webglFramebuffer[ot]);w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer[ot])}else{if(Array.isArray(w.__webglFramebuffer))for(let ot=0;ot<w.__webglFramebuffer.length;ot++)n.deleteFramebuffer(w.__webglFramebuffer[ot]);else n.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&n.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let ot=0;ot<w.__webglColorRenderbuffer.length;ot++)w.__webglColorRenderbuffer[ot]&&n.deleteRenderbuffer(w.__webglColorRenderbuffer[ot]);w.__webglDepthRenderbuffer&&n.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let ht=L.textures;for(let ot=0,xt=ht.length;ot<xt;ot++){let yt=i.get(ht[ot]);yt.__webglTexture&&(n.deleteTexture(yt.__webglTexture),o.memory.textures--),i.remove(ht[ot])}i.remove(L)}let K=0;function Q(){K=0}function it(){return K}function ft(L){K=L}function dt(){let L=K;return L>=s.maxTextures&&$t("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),K+=1,L}function tt(L){let w=[];return w.push(L.wrapS),w.push(L.wrapT),w.push(L.wrapR||0),w.push(L.magFilter),w.push(L.minFilter),w.push(L.anisotropy),w.push(L.internalFormat),w.push(L.format),w.push(L.type),w.push(L.generateMipmaps),w.push(L.mipmapsAutoUpdate),w.push(L.premultiplyAlpha),w.push(L.flipY),w.push(L.unpackAlignment),w.push(L.colorSpace),w.join()}function ut(L,w){let $=i.get(L);if(L.isVideoTexture&&Ne(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&$.__version!==L.version){let ht=L.image;if(ht===null)$t("WebGLRenderer: Texture marked for update but no image data found.");else if(ht.complete===!1)$t("WebGLRenderer: Texture marked for update but image is incomplete");else{Oe($,L,w);return}}else L.isExternalTexture&&($.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+w)}function gt(L,w){let $=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&$.__version!==L.version){Oe($,L,w);return}else L.isExternalTexture&&($.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+w)}function St(L,w){let $=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&$.__version!==L.version){Oe($,L,w);return}e.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+w)}function Mt(L,w){let $=i.get(L);if(L.version>0&&$.__version!==L.version){rn($,L,w);return}e.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+w)}let Ht={[Cl]:n.REPEAT,[Vi]:n.CLAMP_TO_EDGE,[Rl]:n.MIRRORED_REPEAT},se={[Rn]:n.NEAREST,[Op]:n.NEAREST_MIPMAP_NEAREST,[ya]:n.NEAREST_MIPMAP_LINEAR,[Xn]:n.LINEAR,[nc]:n.LINEAR_MIPMAP_NEAREST,[ms]:n.LINEAR_MIPMAP_LINEAR},Vt={[zp]:n.NEVER,[Gu]:n.ALWAYS,[Vp]:n.LESS,[zu]:n.LEQUAL,[Gp]:n.EQUAL,[Vu]:n.GEQUAL,[Hp]:n.GREATER,[Wp]:n.NOTEQUAL};function he(L,w){if(w.type===_i&&t.has("OES_texture_float_linear")===!1&&(w.magFilter===Xn||w.magFilter===nc||w.magFilter===ya||w.magFilter===ms||w.minFilter===Xn||w.minFilter===nc||w.minFilter===ya||w.minFilter===ms)&&$t("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(L,n.TEXTURE_WRAP_S,Ht[w.wrapS]),n.texParameteri(L,n.TEXTURE_WRAP_T,Ht[w.wrapT]),(L===n.TEXTURE_3D||L===n.TEXTURE_2D_ARRAY)&&n.texParameteri(L,n.TEXTURE_WRAP_R,Ht[w.wrapR]),n.texParameteri(L,n.TEXTURE_MAG_FILTER,se[w.magFilter]),n.texParameteri(L,n.TEXTURE_MIN_FILTER,se[w.minFilter]),w.compareFunction&&(n.texParameteri(L,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(L,n.TEXTURE_COMPARE_FUNC,Vt[w.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===Rn||w.minFilter!==ya&&w.minFilter!==ms||w.type===_i&&t.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||i.get(w).__currentAnisotropy){let $=t.get("EXT_texture_filter_anisotropic");n.texParameterf(L,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),i.get(w).__currentAnisotropy=w.anisotropy}}}function ae(L,w){let $=!1;L.__webglInit===void 0&&(L.__webglInit=!0,w.addEventListener("dispose",R),P(w));let ht=w.source,ot=f.get(ht);ot===void 0&&(ot={},f.set(ht,ot));let xt=tt(w);if(xt!==L.__cacheKey){ot[xt]===void 0&&(ot[xt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,$=!0),ot[xt].usedTimes++;let yt=ot[L.__cacheKey];yt!==void 0&&(ot[L.__cacheKey].usedTimes--,yt.usedTimes===0&&H(w)),L.__cacheKey=xt,L.__webglTexture=ot[xt].texture}return $}function ne(L,w,$){return Math.floor(Math.floor(L/$)/w)}function We(L,w,$,ht){let xt=L.updateRanges;if(xt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,w.width,w.height,$,ht,w.data);else{xt.sort((k,rt)=>k.start-rt.start);let yt=0;for(let k=1;k<xt.length;k++){let rt=xt[yt],nt=xt[k],At=rt.start+rt.count,_t=ne(nt.start,w.width,4),bt=ne(rt.start,w.width,4);nt.start<=At+1&&_t===bt&&ne(nt.start+nt.count-1,w.width,4)===_t?rt.count=Math.max(rt.count,nt.start+nt.count-rt.start):(++yt,xt[yt]=nt)}xt.length=yt+1;let et=e.getParameter(n.UNPACK_ROW_LENGTH),st=e.getParameter(n.UNPACK_SKIP_PIXELS),mt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,w.width);for(let k=0,rt=xt.length;k<rt;k++){let nt=xt[k],At=Math.floor(nt.start/4),_t=Math.ceil(nt.count/4),bt=At%w.width,Gt=Math.floor(At/w.width),Kt=_t,ct=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Gt),e.texSubImage2D(n.TEXTURE_2D,0,bt,Gt,Kt,ct,$,ht,w.data)}L.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,et),e.pixelStorei(n.UNPACK_SKIP_PIXELS,st),e.pixelStorei(n.UNPACK_SKIP_ROWS,mt)}}function Oe(L,w,$){let ht=n.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(ht=n.TEXTURE_2D_ARRAY),w.isData3DTexture&&(ht=n.TEXTURE_3D);let ot=ae(L,w),xt=w.source;e.bindTexture(ht,L.__webglTexture,n.TEXTURE0+$);let yt=i.get(xt);if(xt.version!==yt.__version||ot===!0){if(e.activeTexture(n.TEXTURE0+$),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let ct=_e.getPrimaries(_e.workingColorSpace),Ft=w.colorSpace===_s?null:_e.getPrimaries(w.colorSpace),Jt=w.colorSpace===_s||ct===Ft?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Jt)}e.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment);let st=x(w.image,!1,s.maxTextureSize);st=zt(w,st);let mt=r.convert(w.format,w.colorSpace),k=r.convert(w.type),rt=M(w.internalFormat,mt,k,w.normalized,w.colorSpace,w.isVideoTexture);he(ht,w);let nt,At=w.mipmaps,_t=w.isVideoTexture!==!0,bt=yt.__version===void 0||ot===!0,Gt=xt.dataReady,Kt=S(w,st);if(w.isDepthTexture)rt=y(w.format===gs,w.type),bt&&(_t?e.texStorage2D(n.TEXTURE_2D,1,rt,st.width,st.height):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,mt,k,null));else if(w.isDataTexture)if(At.length>0){_t&&bt&&e.texStorage2D(n.TEXTURE_2D,Kt,rt,At[0].width,At[0].height);for(let ct=0,Ft=At.length;ct<Ft;ct++)nt=At[ct],_t?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,k,nt.data):e.texImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,mt,k,nt.data);w.generateMipmaps=!1}else _t?(bt&&e.texStorage2D(n.TEXTURE_2D,Kt,rt,st.width,st.height),Gt&&We(w,st,mt,k)):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,mt,k,st.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){_t&&bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Kt,rt,At[0].width,At[0].height,st.depth);for(let ct=0,Ft=At.length;ct<Ft;ct++)if(nt=At[ct],w.format!==Ri)if(mt!==null)if(_t){if(Gt)if(w.layerUpdates.size>0){let Jt=ju(nt.width,nt.height,w.format,w.type);for(let Ct of w.layerUpdates){let oe=nt.data.subarray(Ct*Jt/nt.data.BYTES_PER_ELEMENT,(Ct+1)*Jt/nt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,Ct,nt.width,nt.height,1,mt,oe)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,nt.width,nt.height,st.depth,mt,nt.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ct,rt,nt.width,nt.height,st.depth,0,nt.data,0,0);else $t("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _t?Gt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,nt.width,nt.height,st.depth,mt,k,nt.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ct,rt,nt.width,nt.height,st.depth,0,mt,k,nt.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{_t&&bt&&e.texStorage2D(n.TEXTURE_2D,Kt,rt,At[0].width,At[0].height);for(let ct=0,Ft=At.length;ct<Ft;ct++)nt=At[ct],w.format!==Ri?mt!==null?_t?Gt&&e.compressedTexSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,nt.data):e.compressedTexImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,nt.data):$t("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_t?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,k,nt.data):e.texImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,mt,k,nt.data)}else if(w.isDataArrayTexture)if(_t){if(bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Kt,rt,st.width,st.height,st.depth),Gt)if(w.layerUpdates.size>0){let ct=ju(st.width,st.height,w.format,w.type);for(let Ft of w.layerUpdates){let Jt=st.data.subarray(Ft*ct/st.data.BYTES_PER_ELEMENT,(Ft+1)*ct/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ft,st.width,st.height,1,mt,k,Jt)}w.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,mt,k,st.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,rt,st.width,st.height,st.depth,0,mt,k,st.data);else if(w.isData3DTexture)_t?(bt&&e.texStorage3D(n.TEXTURE_3D,Kt,rt,st.width,st.height,st.depth),Gt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,mt,k,st.data)):e.texImage3D(n.TEXTURE_3D,0,rt,st.width,st.height,st.depth,0,mt,k,st.data);else if(w.isFramebufferTexture){if(bt)if(_t)e.texStorage2D(n.TEXTURE_2D,Kt,rt,st.width,st.height);else{let ct=st.width,Ft=st.height;for(let Jt=0;Jt<Kt;Jt++)e.texImage2D(n.TEXTURE_2D,Jt,rt,ct,Ft,0,mt,k,null),ct>>=1,Ft>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in n){let ct=n.canvas;if(ct.hasAttribute("layoutsubtree")||ct.setAttribute("layoutsubtree","true"),st.parentNode!==ct){ct.appendChild(st),u.add(w),ct.onpaint=Ft=>{let Jt=Ft.changedElements;for(let Ct of u)Jt.includes(Ct.image)&&(Ct.needsUpdate=!0)},ct.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,st);else{let Jt=n.RGBA,Ct=n.RGBA,oe=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Jt,Ct,oe,st)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(At.length>0){if(_t&&bt){let ct=Xt(At[0]);e.texStorage2D(n.TEXTURE_2D,Kt,rt,ct.width,ct.height)}for(let ct=0,Ft=At.length;ct<Ft;ct++)nt=At[ct],_t?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,mt,k,nt):e.texImage2D(n.TEXTURE_2D,ct,rt,mt,k,nt);w.generateMipmaps=!1}else if(_t){if(bt){let ct=Xt(st);e.texStorage2D(n.TEXTURE_2D,Kt,rt,ct.width,ct.height)}Gt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,mt,k,st)}else e.texImage2D(n.TEXTURE_2D,0,rt,mt,k,st);A(w)&&w.mipmapsAutoUpdate===!0&&b(ht),yt.__version=xt.version,w.onUpdate&&w.onUpdate(w)}L.__version=w.version}function rn(L,w,$){if(w.image.length!==6)return;let ht=ae(L,w),ot=w.source;e.bindTexture(n.TEXTURE_CUBE_MAP,L.__webglTexture,n.TEXTURE0+$);let xt=i.get(ot);if(ot.version!==xt.__version||ht===!0){e.activeTexture(n.TEXTURE0+$);let yt=_e.getPrimaries(_e.workingColorSpace),et=w.colorSpace===_s?null:_e.getPrimaries(w.colorSpace),st=w.colorSpace===_s||yt===et?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let mt=w.isCompressedTexture||w.image[0].isCompressedTexture,k=w.image[0]&&w.image[0].isDataTexture,rt=[];for(let Ct=0;Ct<6;Ct++)!mt&&!k?rt[Ct]=x(w.image[Ct],!0,s.maxCubemapSize):rt[Ct]=k?w.image[Ct].image:w.image[Ct],rt[Ct]=zt(w,rt[Ct]);let nt=rt[0],At=r.convert(w.format,w.colorSpace),_t=r.convert(w.type),bt=M(w.internalFormat,At,_t,w.normalized,w.colorSpace),Gt=w.isVideoTexture!==!0,Kt=xt.__version===void 0||ht===!0,ct=ot.dataReady,Ft=S(w,nt);he(n.TEXTURE_CUBE_MAP,w);let Jt;if(w.isDepthTexture){if(bt=y(w.format===gs,w.type),Kt)if(Gt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,bt,nt.width,nt.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,nt.width,nt.height,0,At,_t,null)}else if(mt){Gt&&Kt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Ft,bt,nt.width,nt.height);for(let Ct=0;Ct<6;Ct++){Jt=rt[Ct].mipmaps;for(let oe=0;oe<Jt.length;oe++){let ke=Jt[oe];w.format!==Ri?At!==null?Gt?ct&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,0,0,ke.width,ke.height,At,ke.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,bt,ke.width,ke.height,0,ke.data):$t("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,0,0,ke.width,ke.height,At,_t,ke.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,bt,ke.width,ke.height,0,At,_t,ke.data)}}}else{if(Jt=w.mipmaps,Gt&&Kt){Jt.length>0&&Ft++;let Ct=Xt(rt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Ft,bt,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(k){Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,rt[Ct].width,rt[Ct].height,At,_t,rt[Ct].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,rt[Ct].width,rt[Ct].height,0,At,_t,rt[Ct].data);for(let oe=0;oe<Jt.length;oe++){let Bn=Jt[oe].image[Ct].image;Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,0,0,Bn.width,Bn.height,At,_t,Bn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,bt,Bn.width,Bn.height,0,At,_t,Bn.data)}}else{Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,At,_t,rt[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,At,_t,rt[Ct]);for(let oe=0;oe<Jt.length;oe++){let ke=Jt[oe];Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,0,0,At,_t,ke.image[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,bt,At,_t,ke.image[Ct])}}}A(w)&&w.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),xt.__version=ot.version,w.onUpdate&&w.onUpdate(w)}L.__version=w.version}function Ie(L,w,$,ht,ot,xt){let yt=r.convert($.format,$.colorSpace),et=r.convert($.type),st=M($.internalFormat,yt,et,$.normalized,$.colorSpace),mt=i.get(w),k=i.get($);if(k.__renderTarget=w,!mt.__hasExternalTextures){let rt=Math.max(1,w.width>>xt),nt=Math.max(1,w.height>>xt);ot===n.TEXTURE_3D||ot===n.TEXTURE_2D_ARRAY?e.texImage3D(ot,xt,st,rt,nt,w.depth,0,yt,et,null):e.texImage2D(ot,xt,st,rt,nt,0,yt,et,null)}e.bindFramebuffer(n.FRAMEBUFFER,L),wt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ht,ot,k.__webglTexture,0,re(w)):(ot===n.TEXTURE_2D||ot>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ot<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ht,ot,k.__webglTexture,xt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Mn(L,w,$){if(n.bindRenderbuffer(n.RENDERBUFFER,L),w.depthBuffer){let ht=w.depthTexture,ot=ht&&ht.isDepthTexture?ht.type:null,xt=y(w.stencilBuffer,ot),yt=w.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;wt(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,re(w),xt,w.width,w.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,re(w),xt,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,xt,w.width,w.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,yt,n.RENDERBUFFER,L)}else{let ht=w.textures;for(let ot=0;ot<ht.length;ot++){let xt=ht[ot],yt=r.convert(xt.format,xt.colorSpace),et=r.convert(xt.type),st=M(xt.internalFormat,yt,et,xt.normalized,xt.colorSpace);wt(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,re(w),st,w.width,w.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,re(w),st,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,st,w.width,w.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ye(L,w,$){let ht=w.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,L),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ot=i.get(w.depthTexture);ot.__renderTarget=w;let xt=ht?w.depthTexture.image[0]:w.depthTexture.image;(!ot.__webglTexture||xt.width!==w.width||xt.height!==w.height)&&(xt.width=w.width,xt.height=w.height,w.depthTexture.needsUpdate=!0),ht?Mt(w.depthTexture,0):ut(w.depthTexture,0);let yt=ot.__webglTexture,et=re(w),st=ht?n.TEXTURE_CUBE_MAP_POSITIVE_X+$:n.TEXTURE_2D,mt=w.depthTexture.format===gs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(w.depthTexture.format===cs)wt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,st,yt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,mt,st,yt,0);else if(w.depthTexture.format===gs)wt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,st,yt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,mt,st,yt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function pn(L){let w=i.get(L),$=L.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==L.depthTexture){let ht=L.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),ht){let ot=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,ht.removeEventListener("dispose",ot)};ht.addEventListener("dispose",ot),w.__depthDisposeCallback=ot}w.__boundDepthTexture=ht}if(L.depthTexture&&!w.__autoAllocateDepthBuffer)if($)for(let ht=0;ht<6;ht++)ye(w.__webglFramebuffer[ht],L,ht);else L.texture.mipmaps.length>0?ye(w.__webglFramebuffer[0],L,0):ye(w.__webglFramebuffer,L,0);else if($){w.__webglDepthbuffer=[];for(let ht=0;ht<6;ht++)if(e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[ht]),w.__webglDepthbuffer[ht]===void 0)w.__webglDepthbuffer[ht]=n.createRenderbuffer(),Mn(w.__webglDepthbuffer[ht],L,!1);else{let ot=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xt=w.__webglDepthbuffer[ht];n.bindRenderbuffer(n.RENDERBUFFER,xt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,xt)}}else if(L.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=n.createRenderbuffer(),Mn(w.__webglDepthbuffer,L,!1);else{let ot=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xt=w.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,xt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ye(L,w,$){let ht=i.get(L);w!==void 0&&Ie(ht.__webglFramebuffer,L,L.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&pn(L)}function on(L){let w=L.texture,$=i.get(L),ht=i.get(w);L.addEventListener("dispose",F),P(L);let ot=L.textures,xt=L.isWebGLCubeRenderTarget===!0,yt=ot.length>1;if(yt||(ht.__webglTexture===void 0&&(ht.__webglTexture=n.createTexture()),ht.__version=w.version,o.memory.textures++),xt){$.__webglFramebuffer=[];for(let et=0;et<6;et++)if(w.mipmaps.length>0){$.__webglFramebuffer[et]=[];for(let st=0;st<w.mipmaps.length;st++)$.__webglFramebuffer[et][st]=n.createFramebuffer()}else $.__webglFramebuffer[et]=n.createFramebuffer()}else{if(w.mipmaps.length>0){$.__webglFramebuffer=[];for(let et=0;et<w.mipmaps.length;et++)$.__webglFramebuffer[et]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(yt)for(let et=0,st=ot.length;et<st;et++){let mt=i.get(ot[et]);mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture(),o.memory.textures++)}if(L.samples>0&&wt(L)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let et=0;et<ot.length;et++){let st=ot[et];$.__webglColorRenderbuffer[et]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[et]);let mt=r.convert(st.format,st.colorSpace),k=r.convert(st.type),rt=M(st.internalFormat,mt,k,st.normalized,st.colorSpace,L.isXRRenderTarget===!0),nt=re(L);n.renderbufferStorageMultisample(n.RENDERBUFFER,nt,rt,L.width,L.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+et,n.RENDERBUFFER,$.__webglColorRenderbuffer[et])}n.bindRenderbuffer(n.RENDERBUFFER,null),L.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),Mn($.__webglDepthRenderbuffer,L,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xt){e.bindTexture(n.TEXTURE_CUBE_MAP,ht.__webglTexture),he(n.TEXTURE_CUBE_MAP,w);for(let et=0;et<6;et++)if(w.mipmaps.length>0)for(let st=0;st<w.mipmaps.length;st++)Ie($.__webglFramebuffer[et][st],L,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,st);else Ie($.__webglFramebuffer[et],L,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);A(w)?b(n.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}else if(yt){for(let et=0,st=ot.length;et<st;et++){let mt=ot[et],k=i.get(mt),rt=n.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(rt=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,k.__webglTexture),he(rt,mt),Ie($.__webglFramebuffer,L,mt,n.COLOR_ATTACHMENT0+et,rt,0),A(mt)&&b(rt)}e.unbindTexture()}else{let et=n.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(et=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(et,ht.__webglTexture),he(et,w),w.mipmaps.length>0)for(let st=0;st<w.mipmaps.length;st++)Ie($.__webglFramebuffer[st],L,w,n.COLOR_ATTACHMENT0,et,st);else Ie($.__webglFramebuffer,L,w,n.COLOR_ATTACHMENT0,et,0);A(w)?b(et):w.mipmaps.length>0&&n.texParameteri(et,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}L.depthBuffer&&pn(L)}function B(L){let w=L.textures;for(let $=0,ht=w.length;$<ht;$++){let ot=w[$];if(A(ot)&&ot.mipmapsAutoUpdate===!0){let xt=C(L),yt=i.get(ot).__webglTexture;e.bindTexture(xt,yt),b(xt),e.unbindTexture()}}}let Rt=[];function qt(L){if(L.samples>0){if(wt(L)===!1){let w=L.textures,$=L.width,ht=L.height,ot=n.COLOR_BUFFER_BIT,xt=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,yt=i.get(L),et=w.length>1;if(et)for(let mt=0;mt<w.length;mt++)e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,yt.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglFramebuffer);for(let mt=0;mt<w.length;mt++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(ot|=n.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(ot|=n.STENCIL_BUFFER_BIT)),et){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let k=i.get(w[mt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,k,0)}n.blitFramebuffer(0,0,$,ht,0,0,$,ht,ot,n.NEAREST),l===!0&&(Rt.length=0,Rt.push(n.COLOR_ATTACHMENT0+mt),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&Rt.push(xt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Rt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),et)for(let mt=0;mt<w.length;mt++){e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let k=i.get(w[mt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,k,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&l){let w=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[w])}}}function re(L){return Math.min(s.maxSamples,L.samples)}function wt(L){let w=i.get(L);return L.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Ne(L){let w=o.render.frame;h.get(L)!==w&&(h.set(L,w),L.update())}function zt(L,w){let $=L.colorSpace,ht=L.format,ot=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||$!==Ko&&$!==_s&&(_e.getTransfer($)===Ae?(ht!==Ri||ot!==Kn)&&$t("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):jt("WebGLTextures: Unsupported texture color space:",$)),w}function Xt(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=dt,this.resetTextureUnits=Q,this.getTextureUnits=it,this.setTextureUnits=ft,this.setTexture2D=ut,this.setTexture2DArray=gt,this.setTexture3D=St,this.setTextureCube=Mt,this.rebindTextures=Ye,this.setupRenderTarget=on,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=qt,this.setupDepthRenderbuffer=pn,this.setupFrameBufferTexture=Ie,this.useMultisampledRTT=wt,this.dispose=G}function FM(n,t){function e(i,s=_s){let r,o=_e.getTransfer(s);if(i===Kn)return n.UNSIGNED_BYTE;if(i===sc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===rc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Du)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Uu)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Lu)return n.BYTE;if(i===Nu)return n.SHORT;if(i===co)return n.UNSIGNED_SHORT;if(i===ic)return n.INT;if(i===Ei)return n.UNSIGNED_INT;if(i===_i)return n.FLOAT;if(i===Ci)return n.HALF_FLOAT;if(i===Ou)return n.ALPHA;if(i===Fu)return n.RGB;if(i===Ri)return n.RGBA;if(i===cs)return n.DEPTH_COMPONENT;if(i===gs)return n.DEPTH_STENCIL;if(i===oc)return n.RED;if(i===ac)return n.RED_INTEGER;if(i===Xs)return n.RG;if(i===lc)return n.RG_INTEGER;if(i===cc)return n.RGBA_INTEGER;if(i===va||i===ba||i===Sa||i===Ma)if(o===Ae)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===va)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===ba)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Sa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ma)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===va)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===ba)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Sa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ma)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===hc||i===uc||i===dc||i===fc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===hc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===uc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===dc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===fc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===pc||i===mc||i===gc||i===_c||i===xc||i===wa||i===yc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===pc||i===mc)return o===Ae?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===gc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===_c)return r.COMPRESSED_R11_EAC;if(i===xc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===wa)return r.COMPRESSED_RG11_EAC;if(i===yc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===vc||i===bc||i===Sc||i===Mc||i===wc||i===Ac||i===Tc||i===Ec||i===Cc||i===Rc||i===Pc||i===Ic||i===Lc||i===Nc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===vc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===bc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Sc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Mc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===wc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Ac)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Tc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ec)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Cc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Rc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Pc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Ic)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Lc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Nc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Dc||i===Uc||i===Oc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Dc)return o===Ae?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Uc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Oc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Fc||i===kc||i===Aa||i===Bc)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Fc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===kc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Aa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Bc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===dr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var kM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,BM=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,ad=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new aa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Wi({vertexShader:kM,fragmentShader:BM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ln(new ca(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},ld=class extends Ti{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,m=null,_=typeof XRWebGLBinding<"u",p=new ad,g={},x=e.getContextAttributes(),A=null,b=null,C=[],M=[],y=new Yt,S=null,P=null,I=new Wn;I.viewport=new $e;let R=new Wn;R.viewport=new $e;let F=[I,R],z=new jl,U=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let ut=C[tt];return ut===void 0&&(ut=new eo,C[tt]=ut),ut.getTargetRaySpace()},this.getControllerGrip=function(tt){let ut=C[tt];return ut===void 0&&(ut=new eo,C[tt]=ut),ut.getGripSpace()},this.getHand=function(tt){let ut=C[tt];return ut===void 0&&(ut=new eo,C[tt]=ut),ut.getHandSpace()};function q(tt){let ut=M.indexOf(tt.inputSource);if(ut===-1)return;let gt=C[ut];gt!==void 0&&(gt.update(tt.inputSource,tt.frame,c||o),gt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function H(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",lt);for(let tt=0;tt<C.length;tt++){let ut=M[tt];ut!==null&&(M[tt]=null,C[tt].disconnect(ut))}U=null,G=null,p.reset();for(let tt in g)delete g[tt];if(t.setRenderTarget(A),f=null,d=null,u=null,s=null,b=null,dt.stop(),i.isPresenting=!1,t.setPixelRatio(S),t.setSize(y.width,y.height,!1),P!==null){let tt=P.camera;tt.fov=P.fov,tt.zoom=P.zoom,tt.updateProjectionMatrix(),P=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,i.isPresenting===!0&&$t("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,i.isPresenting===!0&&$t("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&_&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(A=t.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",H),s.addEventListener("inputsourceschange",lt),x.xrCompatible!==!0&&await e.makeXRCompatible(),S=t.getPixelRatio(),t.getSize(y),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let gt=null,St=null,Mt=null;x.depth&&(Mt=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,gt=x.stencil?gs:cs,St=x.stencil?dr:Ei);let Ht={colorFormat:e.RGBA8,depthFormat:Mt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Ht),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),b=new ai(d.textureWidth,d.textureHeight,{format:Ri,type:Kn,depthTexture:new fs(d.textureWidth,d.textureHeight,St,void 0,void 0,void 0,void 0,void 0,void 0,gt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let gt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,gt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new ai(f.framebufferWidth,f.framebufferHeight,{format:Ri,type:Kn,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),dt.setContext(s),dt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function lt(tt){for(let ut=0;ut<tt.removed.length;ut++){let gt=tt.removed[ut],St=M.indexOf(gt);St>=0&&(M[St]=null,C[St].disconnect(gt))}for(let ut=0;ut<tt.added.length;ut++){let gt=tt.added[ut],St=M.indexOf(gt);if(St===-1){for(let Ht=0;Ht<C.length;Ht++)if(Ht>=M.length){M.push(gt),St=Ht;break}else if(M[Ht]===null){M[Ht]=gt,St=Ht;break}if(St===-1)break}let Mt=C[St];Mt&&Mt.connect(gt)}}function K(tt,ut){ut===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(ut.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let ut=tt.near,gt=tt.far;p.texture!==null&&(p.depthNear>0&&(ut=p.depthNear),p.depthFar>0&&(gt=p.depthFar)),z.near=R.near=I.near=ut,z.far=R.far=I.far=gt,(U!==z.near||G!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),U=z.near,G=z.far),z.layers.mask=tt.layers.mask|6,I.layers.mask=z.layers.mask&-5,R.layers.mask=z.layers.mask&-3;let St=tt.parent,Mt=z.cameras;K(z,St);for(let Ht=0;Ht<Mt.length;Ht++)K(Mt[Ht],St);z.projectionMatrix.copy(I.projectionMatrix),z.projectionMatrixInverse.copy(I.projectionMatrixInverse),P===null&&tt.isPerspectiveCamera&&(P={camera:tt,fov:tt.fov,zoom:tt.zoom}),Q(tt,z,St)};function Q(tt,ut,gt){gt===null?tt.matrix.copy(ut.matrixWorld):(tt.matrix.copy(gt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(ut.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(ut.projectionMatrix),tt.projectionMatrixInverse.copy(ut.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=jr*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(tt){l=tt,d!==null&&(d.fixedFoveation=tt),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=tt)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(z)},this.getCameraTexture=function(tt){return g[tt]};let it=null;function ft(tt,ut){if(h=ut.getViewerPose(c||o),m=ut,h!==null){let gt=h.views;f!==null&&(t.setRenderTargetFramebuffer(b,f.framebuffer),t.setRenderTarget(b));let St=!1;gt.length!==z.cameras.length&&(z.cameras.length=0,St=!0);for(let Vt=0;Vt<gt.length;Vt++){let he=gt[Vt],ae=null;if(f!==null)ae=f.getViewport(he);else{let We=u.getViewSubImage(d,he);ae=We.viewport,Vt===0&&(t.setRenderTargetTextures(b,We.colorTexture,We.depthStencilTexture),t.setRenderTarget(b))}let ne=F[Vt];ne===void 0&&(ne=new Wn,ne.layers.enable(Vt),ne.viewport=new $e,F[Vt]=ne),ne.matrix.fromArray(he.transform.matrix),ne.matrix.decompose(ne.position,ne.quaternion,ne.scale),ne.projectionMatrix.fromArray(he.projectionMatrix),ne.projectionMatrixInverse.copy(ne.projectionMatrix).invert(),ne.viewport.set(ae.x,ae.y,ae.width,ae.height),Vt===0&&(z.matrix.copy(ne.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),St===!0&&z.cameras.push(ne)}let Mt=s.enabledFeatures;if(Mt&&Mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){u=i.getBinding();let Vt=u.getDepthInformation(gt[0]);Vt&&Vt.isValid&&Vt.texture&&p.init(Vt,s.renderState)}if(Mt&&Mt.includes("camera-access")&&_){t.state.unbindTexture(),u=i.getBinding();for(let Vt=0;Vt<gt.length;Vt++){let he=gt[Vt].camera;if(he){let ae=g[he];ae||(ae=new aa,g[he]=ae);let ne=u.getCameraImage(he);ae.sourceTexture=ne}}}}for(let gt=0;gt<C.length;gt++){let St=M[gt],Mt=C[gt];St!==null&&Mt!==void 0&&Mt.update(St,ut,c||o)}it&&it(tt,ut),ut.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ut}),m=null}let dt=new Mm;dt.setAnimationLoop(ft),this.setAnimationLoop=function(tt){it=tt},this.dispose=function(){}}},zM=new pe,Nm=new ee;Nm.set(-1,0,0,0,1,0,0,0,1);function VM(n,t){function e(p,g){p.matrixAutoUpdate===!0&&p.updateMatrix(),g.value.copy(p.matrix)}function i(p,g){g.color.getRGB(p.fogColor.value,Zu(n)),g.isFog?(p.fogNear.value=g.near,p.fogFar.value=g.far):g.isFogExp2&&(p.fogDensity.value=g.density)}function s(p,g,x,A,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(p,g):g.isMeshLambertMaterial?(r(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(p,g),u(p,g)):g.isMeshPhongMaterial?(r(p,g),h(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(p,g),d(p,g),g.isMeshPhysicalMaterial&&f(p,g,b)):g.isMeshMatcapMaterial?(r(p,g),m(p,g)):g.isMeshDepthMaterial?r(p,g):g.isMeshDistanceMaterial?(r(p,g),_(p,g)):g.isMeshNormalMaterial?r(p,g):g.isLineBasicMaterial?(o(p,g),g.isLineDashedMaterial&&a(p,g)):g.isPointsMaterial?l(p,g,x,A):g.isSpriteMaterial?c(p,g):g.isShadowMaterial?(p.color.value.copy(g.color),p.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(p,g){p.opacity.value=g.opacity,g.color&&p.diffuse.value.copy(g.color),g.emissive&&p.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(p.map.value=g.map,e(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.bumpMap&&(p.bumpMap.value=g.bumpMap,e(g.bumpMap,p.bumpMapTransform),p.bumpScale.value=g.bumpScale,g.side===$n&&(p.bumpScale.value*=-1)),g.normalMap&&(p.normalMap.value=g.normalMap,e(g.normalMap,p.normalMapTransform),p.normalScale.value.copy(g.normalScale),g.side===$n&&p.normalScale.value.negate()),g.displacementMap&&(p.displacementMap.value=g.displacementMap,e(g.displacementMap,p.displacementMapTransform),p.displacementScale.value=g.displacementScale,p.displacementBias.value=g.displacementBias),g.emissiveMap&&(p.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,p.emissiveMapTransform)),g.specularMap&&(p.specularMap.value=g.specularMap,e(g.specularMap,p.specularMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest);let x=t.get(g),A=x.envMap,b=x.envMapRotation;A&&(p.envMap.value=A,p.envMapRotation.value.setFromMatrix4(zM.makeRotationFromEuler(b)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Nm),p.reflectivity.value=g.reflectivity,p.ior.value=g.ior,p.refractionRatio.value=g.refractionRatio),g.lightMap&&(p.lightMap.value=g.lightMap,p.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,p.lightMapTransform)),g.aoMap&&(p.aoMap.value=g.aoMap,p.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,p.aoMapTransform))}function o(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,g.map&&(p.map.value=g.map,e(g.map,p.mapTransform))}function a(p,g){p.dashSize.value=g.dashSize,p.totalSize.value=g.dashSize+g.gapSize,p.scale.value=g.scale}function l(p,g,x,A){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.size.value=g.size*x,p.scale.value=A*.5,g.map&&(p.map.value=g.map,e(g.map,p.uvTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function c(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.rotation.value=g.rotation,g.map&&(p.map.value=g.map,e(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function h(p,g){p.specular.value.copy(g.specular),p.shininess.value=Math.max(g.shininess,1e-4)}function u(p,g){g.gradientMap&&(p.gradientMap.value=g.gradientMap)}function d(p,g){p.metalness.value=g.metalness,g.metalnessMap&&(p.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,p.metalnessMapTransform)),p.roughness.value=g.roughness,g.roughnessMap&&(p.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,p.roughnessMapTransform)),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)}function f(p,g,x){p.ior.value=g.ior,g.diffuseRoughness>0&&(p.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),g.sheen>0&&(p.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),p.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(p.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,p.sheenColorMapTransform)),g.sheenRoughnessMap&&(p.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,p.sheenRoughnessMapTransform))),g.clearcoat>0&&(p.clearcoat.value=g.clearcoat,p.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(p.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,p.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(p.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===$n&&p.clearcoatNormalScale.value.negate())),g.dispersion>0&&(p.dispersion.value=g.dispersion),g.retroreflectivity>0&&(p.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(p.iridescence.value=g.iridescence,p.iridescenceIOR.value=g.iridescenceIOR,p.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(p.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,p.iridescenceMapTransform)),g.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),g.transmission>0&&(p.transmission.value=g.transmission,p.transmissionSamplerMap.value=x.texture,p.transmissionSamplerSize.value.set(x.width,x.height),g.transmissionMap&&(p.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,p.transmissionMapTransform)),p.thickness.value=g.thickness,g.thicknessMap&&(p.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=g.attenuationDistance,p.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(p.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(p.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=g.specularIntensity,p.specularColor.value.copy(g.specularColor),g.specularColorMap&&(p.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,p.specularColorMapTransform)),g.specularIntensityMap&&(p.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,p.specularIntensityMapTransform))}function m(p,g){g.matcap&&(p.matcap.value=g.matcap)}function _(p,g){let x=t.get(g).light;p.referencePosition.value.setFromMatrixPosition(x.matrixWorld),p.nearDistance.value=x.shadow.camera.near,p.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function GM(n,t,e,i){let s={},r={};function o(x,A){let b=A.program;i.uniformBlockBinding(x,b,s[x.id])}function a(x,A){let b=s[x.id];b===void 0&&(m(x),b=l(x),s[x.id]=b,x.addEventListener("dispose",p));let C=A.program;i.updateUBOMapping(x,C);let M=t.render.frame;r[x.id]!==M&&(c(x),r[x.id]=M)}function l(x){let A=n.createBuffer(),b=x.__size,C=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,A),n.bufferData(n.UNIFORM_BUFFER,b,C),n.bindBuffer(n.UNIFORM_BUFFER,null),A}function c(x){let A=s[x.id],b=x.uniforms,C=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,A);for(let M=0,y=b.length;M<y;M++){let S=b[M];if(Array.isArray(S))for(let P=0,I=S.length;P<I;P++)h(S[P],M,P,C);else h(S,M,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(x,A,b,C){if(d(x,A,b,C)===!0){let M=x.__offset,y=x.value;if(Array.isArray(y)){let S=0;for(let P=0;P<y.length;P++){let I=y[P],R=_(I,!0);u(I,x.__data,S),S+=R.storage/Float32Array.BYTES_PER_ELEMENT}}else u(y,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,M,x.__data)}}function u(x,A,b){typeof x=="number"||typeof x=="boolean"?A[b]=x:x.isMatrix3?(A[b]=x.elements[0],A[b+1]=x.elements[1],A[b+2]=x.elements[2],A[b+3]=0,A[b+4]=x.elements[3],A[b+5]=x.elements[4],A[b+6]=x.elements[5],A[b+7]=0,A[b+8]=x.elements[6],A[b+9]=x.elements[7],A[b+10]=x.elements[8],A[b+11]=0):ArrayBuffer.isView(x)?A.set(x.subarray(0,A.length-b),b):x.toArray(A,b)}function d(x,A,b,C){let M=x.value,y=A+"_"+b;if(Array.isArray(M)){C[y]===void 0&&(C[y]=[]);let S=C[y],P=!1;for(let I=0;I<M.length;I++)f(M[I],S,I)===!0&&(P=!0);return P}return f(M,C,y)}function f(x,A,b){if(A[b]===void 0)return typeof x=="number"||typeof x=="boolean"?A[b]=x:ArrayBuffer.isView(x)?A[b]=x.slice():A[b]=x.clone(),!0;{let C=A[b];if(typeof x=="number"||typeof x=="boolean"){if(C!==x)return A[b]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(C.equals(x)===!1)return C.copy(x),!0}}return!1}function m(x){let A=x.uniforms,b=0,C=16;for(let y=0,S=A.length;y<S;y++){let P=Array.isArray(A[y])?A[y]:[A[y]];for(let I=0,R=P.length;I<R;I++){let F=P[I],z=Array.isArray(F.value)?F.value:[F.value],U=Array.isArray(A[y])||Array.isArray(F.value),G=b;for(let H=0,lt=z.length;H<lt;H++){let K=z[H],Q=_(K,U),it=b%C,ft=it%Q.boundary,dt=it+ft;b+=ft,dt!==0&&C-dt<Q.storage&&(b+=C-dt),H===0&&(G=b),b+=Q.storage}let q=F.type==="int"?Int32Array:F.type==="uint"?Uint32Array:Float32Array;F.__data=new q((b-G)/Float32Array.BYTES_PER_ELEMENT),F.__offset=G}}let M=b%C;return M>0&&(b+=C-M),x.__size=b,x.__cache={},this}function _(x,A){let b={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(b.boundary=4,b.storage=4):x.isVector2?(b.boundary=8,b.storage=8):x.isVector3||x.isColor?(b.boundary=16,b.storage=12):x.isVector4?(b.boundary=16,b.storage=16):x.isMatrix3?(b.boundary=16,b.storage=48):x.isMatrix4?(b.boundary=16,b.storage=64):x.isTexture?$t("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(b.boundary=16,b.storage=x.byteLength):$t("WebGLRenderer: Unsupported uniform value type.",x),A===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function p(x){let A=x.target;A.removeEventListener("dispose",p),n.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function g(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:g}}var HM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),$i=null;function WM(){return $i===null&&($i=new ia(HM,16,16,Xs,Ci),$i.name="DFG_LUT",$i.minFilter=Xn,$i.magFilter=Xn,$i.wrapS=Vi,$i.wrapT=Vi,$i.generateMipmaps=!1,$i.needsUpdate=!0),$i}var Wc=class{constructor(t={}){let{canvas:e=$p(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Kn}=t;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let _=f,p=new Set([cc,lc,ac]),g=new Set([Kn,Ei,co,dr,sc,rc]),x=new Uint32Array(4),A=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,M=null,y=[],S=[],P=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Xi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,R=!1,F=null,z=null,U=null,G=null;this._outputColorSpace=si;let q=0,H=0,lt=null,K=-1,Q=null,it=new $e,ft=new $e,dt=null,tt=new Qt(0),ut=0,gt=e.width,St=e.height,Mt=1,Ht=null,se=null,Vt=new $e(0,0,gt,St),he=new $e(0,0,gt,St),ae=!1,ne=new Fs,We=new Dl,Oe=!1,rn=!1,Ie=new pe,Mn=new X,ye=new $e,pn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ye=!1;function on(){return lt===null?Mt:1}let B=i;function Rt(E,V){return e.getContext(E,V)}let qt,re,wt,Ne,zt,Xt,L,w,$,ht,ot,xt,yt,et,st,mt,k,rt,nt,At,_t,bt,Gt;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ft,!1),e.addEventListener("webglcontextrestored",Jt,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),B===null){let V="webgl2";if(B=Rt(V,E),B===null)throw Rt(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Kt()}catch(E){throw e.removeEventListener("webglcontextlost",Ft,!1),e.removeEventListener("webglcontextrestored",Jt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),jt("WebGLRenderer: "+E.message),E}function Kt(){qt=new eS(B),qt.init(),_t=new FM(B,qt),re=new Wb(B,qt,t,_t),wt=new UM(B,qt),re.reversedDepthBuffer&&d&&wt.buffers.depth.setReversed(!0),z=B.createFramebuffer(),U=B.createFramebuffer(),G=B.createFramebuffer(),Ne=new sS(B),zt=new bM,Xt=new OM(B,qt,wt,zt,re,_t,Ne),L=new tS(I),w=new oy(B),bt=new Gb(B,w),$=new nS(B,w,Ne,bt),ht=new oS(B,$,w,bt,Ne),rt=new rS(B,re,Xt),st=new Xb(zt),ot=new vM(I,L,qt,re,bt,st),xt=new VM(I,zt),yt=new MM,et=new RM(qt),k=new Vb(I,L,wt,ht,m,l),mt=new DM(I,ht,re),Gt=new GM(B,Ne,re,wt),nt=new Hb(B,qt,Ne),At=new iS(B,qt,Ne),Ne.programs=ot.programs,I.capabilities=re,I.extensions=qt,I.properties=zt,I.renderLists=yt,I.shadowMap=mt,I.state=wt,I.info=Ne}_!==Kn&&(P=new lS(_,e.width,e.height,a,s,r));let ct=new ld(I,B);this.xr=ct,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let E=qt.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=qt.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return Mt},this.setPixelRatio=function(E){E!==void 0&&(Mt=E,this.setSize(gt,St,!1))},this.getSize=function(E){return E.set(gt,St)},this.setSize=function(E,V,j=!0){if(ct.isPresenting){$t("WebGLRenderer: Can't change size while VR device is presenting.");return}gt=E,St=V,e.width=Math.floor(E*Mt),e.height=Math.floor(V*Mt),j===!0&&(e.style.width=E+"px",e.style.height=V+"px"),P!==null&&P.setSize(e.width,e.height),this.setViewport(0,0,E,V)},this.getDrawingBufferSize=function(E){return E.set(gt*Mt,St*Mt).floor()},this.setDrawingBufferSize=function(E,V,j){gt=E,St=V,Mt=j,e.width=Math.floor(E*j),e.height=Math.floor(V*j),this.setViewport(0,0,E,V)},this.setEffects=function(E){if(_===Kn){jt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let V=0;V<E.length;V++)if(E[V].isOutputPass===!0){$t("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}P.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(it)},this.getViewport=function(E){return E.copy(Vt)},this.setViewport=function(E,V,j,Y){E.isVector4?Vt.set(E.x,E.y,E.z,E.w):Vt.set(E,V,j,Y),wt.viewport(it.copy(Vt).multiplyScalar(on()).round())},this.getScissor=function(E){return E.copy(he)},this.setScissor=function(E,V,j,Y){E.isVector4?he.set(E.x,E.y,E.z,E.w):he.set(E,V,j,Y),wt.scissor(ft.copy(he).multiplyScalar(on()).round())},this.getScissorTest=function(){return ae},this.setScissorTest=function(E){wt.setScissorTest(ae=E)},this.setOpaqueSort=function(E){Ht=E},this.setTransparentSort=function(E){se=E},this.getClearColor=function(E){return E.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(E=!0,V=!0,j=!0){let Y=0;if(E){let Z=!1;if(lt!==null){let Tt=lt.texture.format;Z=p.has(Tt)}if(Z){let Tt=lt.texture.type,Pt=g.has(Tt),Et=k.getClearColor(),It=k.getClearAlpha(),Bt=Et.r,te=Et.g,ue=Et.b;Pt?(x[0]=Bt,x[1]=te,x[2]=ue,x[3]=It,B.clearBufferuiv(B.COLOR,0,x)):(A[0]=Bt,A[1]=te,A[2]=ue,A[3]=It,B.clearBufferiv(B.COLOR,0,A))}else Y|=B.COLOR_BUFFER_BIT}V&&(Y|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&B.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),F=E},this.dispose=function(){e.removeEventListener("webglcontextlost",Ft,!1),e.removeEventListener("webglcontextrestored",Jt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),k.dispose(),yt.dispose(),et.dispose(),Xt.dispose(),zt.dispose(),L.dispose(),ht.dispose(),$.dispose(),bt.dispose(),Gt.dispose(),ot.dispose(),ct.dispose(),ct.removeEventListener("sessionstart",Xa),ct.removeEventListener("sessionend",Ni),ji.stop()};function Ft(E){E.preventDefault(),Wu("WebGLRenderer: Context Lost."),R=!0}function Jt(){Wu("WebGLRenderer: Context Restored."),R=!1;let E=Ne.autoReset,V=mt.enabled,j=mt.autoUpdate,Y=mt.needsUpdate,Z=mt.type;Kt(),Ne.autoReset=E,mt.enabled=V,mt.autoUpdate=j,mt.needsUpdate=Y,mt.type=Z}function Ct(E){jt("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function oe(E){let V=E.target;V.removeEventListener("dispose",oe),ke(V)}function ke(E){Bn(E),zt.remove(E)}function Bn(E){let V=zt.get(E).programs;V!==void 0&&(V.forEach(function(j){ot.releaseProgram(j)}),E.isShaderMaterial&&ot.releaseShaderCache(E))}this.renderBufferDirect=function(E,V,j,Y,Z,Tt){V===null&&(V=pn);let Pt=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Et=Do(E,V,j,Y,Z);wt.setMaterial(Y,Pt);let It=j.index,Bt=1;if(Y.wireframe===!0){if(It=$.getWireframeAttribute(j),It===void 0)return;Bt=2}let te=j.drawRange,ue=j.attributes.position,kt=te.start*Bt,de=(te.start+te.count)*Bt;Tt!==null&&(kt=Math.max(kt,Tt.start*Bt),de=Math.min(de,(Tt.start+Tt.count)*Bt)),It!==null?(kt=Math.max(kt,0),de=Math.min(de,It.count)):ue!=null&&(kt=Math.max(kt,0),de=Math.min(de,ue.count));let qe=de-kt;if(qe<0||qe===1/0)return;bt.setup(Z,Y,Et,j,It);let Ee,Ce=nt;if(It!==null&&(Ee=w.get(It),Ce=At,Ce.setIndex(Ee)),Z.isMesh)Y.wireframe===!0?(wt.setLineWidth(Y.wireframeLinewidth*on()),Ce.setMode(B.LINES)):Ce.setMode(B.TRIANGLES);else if(Z.isLine){let mn=Y.linewidth;mn===void 0&&(mn=1),wt.setLineWidth(mn*on()),Z.isLineSegments?Ce.setMode(B.LINES):Z.isLineLoop?Ce.setMode(B.LINE_LOOP):Ce.setMode(B.LINE_STRIP)}else Z.isPoints?Ce.setMode(B.POINTS):Z.isSprite&&Ce.setMode(B.TRIANGLES);if(Z.isBatchedMesh)if(qt.get("WEBGL_multi_draw"))Ce.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let mn=Z._multiDrawStarts,Ut=Z._multiDrawCounts,an=Z._multiDrawCount,ge=It?w.get(It).bytesPerElement:1,ts=zt.get(Y).currentProgram.getUniforms();for(let ln=0;ln<an;ln++)ts.setValue(B,"_gl_DrawID",ln),Ce.render(mn[ln]/ge,Ut[ln])}else if(Z.isInstancedMesh)Ce.renderInstances(kt,qe,Z.count);else if(j.isInstancedBufferGeometry){let mn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ut=Math.min(j.instanceCount,mn);Ce.renderInstances(kt,qe,Ut)}else Ce.render(kt,qe)};function Io(E,V,j,Y){F!==null&&E.isNodeMaterial&&F.setObject(Y,E),Oe===!0&&st.setState(E,j,!1),E.transparent===!0&&E.side===Fn&&E.forceSinglePass===!1?(E.side=$n,E.needsUpdate=!0,Di(E,V,Y),E.side=Ws,E.needsUpdate=!0,Di(E,V,Y),E.side=Fn):Di(E,V,Y)}this.compile=function(E,V,j=null){j===null&&(j=E),F!==null&&F.renderStart(E,V,j),M=et.get(j),M.init(V),S.push(M),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(V.layers)&&(M.pushLight(Z),Z.castShadow&&M.pushShadow(Z))}),E!==j&&E.traverseVisible(function(Z){Z.isLight&&Z.layers.test(V.layers)&&(M.pushLight(Z),Z.castShadow&&M.pushShadow(Z))}),M.setupLights(),F!==null&&F.updateLights(M.state.lightsArray),rn=this.localClippingEnabled,Oe=st.init(this.clippingPlanes,rn),Oe===!0&&st.setGlobalState(this.clippingPlanes,V),F!==null&&mt.render(M.state.shadowsArray,j,V);let Y=new Set;return E.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Tt=Z.material;if(Tt)if(Array.isArray(Tt))for(let Pt=0;Pt<Tt.length;Pt++){let Et=Tt[Pt];Io(Et,j,V,Z),Y.add(Et)}else Io(Tt,j,V,Z),Y.add(Tt)}),M=S.pop(),F!==null&&F.renderEnd(),Y},this.compileAsync=function(E,V,j=null){let Y=this.compile(E,V,j);return new Promise(Z=>{function Tt(){if(Y.forEach(function(Pt){let It=zt.get(Pt).currentProgram;(It===void 0||It.isReady())&&Y.delete(Pt)}),Y.size===0){Z(E);return}setTimeout(Tt,10)}qt.get("KHR_parallel_shader_compile")!==null?Tt():setTimeout(Tt,10)})};let Mr=null;function Nh(E){Mr&&Mr(E)}function Xa(){ji.stop()}function Ni(){ji.start()}let ji=new Mm;ji.setAnimationLoop(Nh),typeof self<"u"&&ji.setContext(self),this.setAnimationLoop=function(E){Mr=E,ct.setAnimationLoop(E),E===null?ji.stop():ji.start()},ct.addEventListener("sessionstart",Xa),ct.addEventListener("sessionend",Ni),this.render=function(E,V){if(V!==void 0&&V.isCamera!==!0){jt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(R===!0)return;F!==null&&F.renderStart(E,V);let j=ct.enabled===!0&&ct.isPresenting===!0,Y=P!==null&&(lt===null||j)&&P.begin(I,lt);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),ct.enabled===!0&&ct.isPresenting===!0&&(P===null||P.isCompositing()===!1)&&(ct.cameraAutoUpdate===!0&&ct.updateCamera(V),V=ct.getCamera()),E.isScene===!0&&E.onBeforeRender(I,E,V,lt),M=et.get(E,S.length),M.init(V),M.state.textureUnits=Xt.getTextureUnits(),S.push(M),Ie.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?We.setFromArrayCamera(V):ne.setFromProjectionMatrix(Ie,gi,V.reversedDepth),rn=this.localClippingEnabled,Oe=st.init(this.clippingPlanes,rn),C=yt.get(E,y.length),C.init(),y.push(C),this.info.render.frame++,ct.enabled===!0&&ct.isPresenting===!0){let Pt=I.xr.getDepthSensingMesh();Pt!==null&&Qi(Pt,V,-1/0,I.sortObjects)}Qi(E,V,0,I.sortObjects),C.finish(),F!==null&&F.updateLights(M.state.lightsArray),I.sortObjects===!0&&C.sort(Ht,se),Ye=ct.enabled===!1||ct.isPresenting===!1||ct.hasDepthSensing()===!1,Ye&&k.addToRenderList(C,E),this.info.autoReset===!0&&this.info.reset(),Oe===!0&&st.beginShadows();let Z=M.state.shadowsArray;if(mt.render(Z,E,V),Oe===!0&&st.endShadows(),(Y&&P.hasRenderPass())===!1){let Pt=C.opaque,Et=C.transmissive;if(M.setupLights(),V.isArrayCamera){let It=V.cameras;if(Et.length>0)for(let Bt=0,te=It.length;Bt<te;Bt++){let ue=It[Bt];vi(Pt,Et,E,ue)}Ye&&k.render(E);for(let Bt=0,te=It.length;Bt<te;Bt++){let ue=It[Bt];Lo(C,E,ue,ue.viewport)}}else Et.length>0&&vi(Pt,Et,E,V),Ye&&k.render(E),Lo(C,E,V)}lt!==null&&H===0&&(Xt.updateMultisampleRenderTarget(lt),Xt.updateRenderTargetMipmap(lt)),Y&&P.end(I),E.isScene===!0&&E.onAfterRender(I,E,V),bt.resetDefaultState(),K=-1,Q=null,S.pop(),S.length>0?(M=S[S.length-1],Xt.setTextureUnits(M.state.textureUnits),Oe===!0&&st.setGlobalState(I.clippingPlanes,M.state.camera)):M=null,y.pop(),y.length>0?C=y[y.length-1]:C=null,F!==null&&F.renderEnd()};function Qi(E,V,j,Y){if(E.visible===!1)return;if(E.layers.test(V.layers)){if(E.isGroup)j=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(V);else if(E.isLight)M.pushLight(E),E.castShadow&&M.pushShadow(E);else if(E.isSprite){let Pt=V.isArrayCamera?We:ne;if(!E.frustumCulled||E.intersectsFrustum(Pt)){Y&&ye.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Ie);let Et=ht.update(E),It=E.material;It.visible&&C.push(E,Et,It,j,ye.z,null,V)}}else if(E.isMesh||E.isLine||E.isPoints){let Pt=V.isArrayCamera?We:ne;if(!E.frustumCulled||E.intersectsFrustum(Pt)){let Et=ht.update(E),It=E.material;if(Y&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),ye.copy(E.boundingSphere.center)):(Et.boundingSphere===null&&Et.computeBoundingSphere(),ye.copy(Et.boundingSphere.center)),ye.applyMatrix4(E.matrixWorld).applyMatrix4(Ie)),Array.isArray(It)){let Bt=Et.groups;for(let te=0,ue=Bt.length;te<ue;te++){let kt=Bt[te],de=It[kt.materialIndex];de&&de.visible&&C.push(E,Et,de,j,ye.z,kt,V)}}else It.visible&&C.push(E,Et,It,j,ye.z,null,V)}}}let Tt=E.children;for(let Pt=0,Et=Tt.length;Pt<Et;Pt++)Qi(Tt[Pt],V,j,Y)}function Lo(E,V,j,Y){let{opaque:Z,transmissive:Tt,transparent:Pt}=E;M.setupLightsView(j),Oe===!0&&st.setGlobalState(I.clippingPlanes,j),Y&&wt.viewport(it.copy(Y)),Z.length>0&&Ze(Z,V,j),Tt.length>0&&Ze(Tt,V,j),Pt.length>0&&Ze(Pt,V,j),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function vi(E,V,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(M.state.transmissionRenderTarget[Y.id]===void 0){let kt=qt.has("EXT_color_buffer_half_float")||qt.has("EXT_color_buffer_float");M.state.transmissionRenderTarget[Y.id]=new ai(1,1,{generateMipmaps:!0,type:kt?Ci:Kn,minFilter:ms,samples:Math.max(4,re.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:_e.workingColorSpace})}let Tt=M.state.transmissionRenderTarget[Y.id],Pt=Y.viewport||it;Tt.setSize(Pt.z*I.transmissionResolutionScale,Pt.w*I.transmissionResolutionScale);let Et=I.getRenderTarget(),It=I.getActiveCubeFace(),Bt=I.getActiveMipmapLevel();I.setRenderTarget(Tt),I.getClearColor(tt),ut=I.getClearAlpha(),ut<1&&I.setClearColor(16777215,.5),I.clear(),Ye&&k.render(j);let te=I.toneMapping;I.toneMapping=Xi;let ue=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),M.setupLightsView(Y),Oe===!0&&st.setGlobalState(I.clippingPlanes,Y),Ze(E,j,Y),Xt.updateMultisampleRenderTarget(Tt),Xt.updateRenderTargetMipmap(Tt),qt.has("WEBGL_multisampled_render_to_texture")===!1){let kt=!1;for(let de=0,qe=V.length;de<qe;de++){let Ee=V[de],{object:Ce,geometry:mn,material:Ut,group:an}=Ee;if(Ut.side===Fn&&Ce.layers.test(Y.layers)){let ge=Ut.side;Ut.side=$n,Ut.needsUpdate=!0,tn(Ce,j,Y,mn,Ut,an),Ut.side=ge,Ut.needsUpdate=!0,kt=!0}}kt===!0&&(Xt.updateMultisampleRenderTarget(Tt),Xt.updateRenderTargetMipmap(Tt))}I.setRenderTarget(Et,It,Bt),I.setClearColor(tt,ut),ue!==void 0&&(Y.viewport=ue),I.toneMapping=te}function Ze(E,V,j){let Y=V.isScene===!0?V.overrideMaterial:null;for(let Z=0,Tt=E.length;Z<Tt;Z++){let Pt=E[Z],{object:Et,geometry:It,group:Bt}=Pt,te=Pt.material;te.allowOverride===!0&&Y!==null&&(te=Y),Et.layers.test(j.layers)&&tn(Et,V,j,It,te,Bt)}}function tn(E,V,j,Y,Z,Tt){F!==null&&Z.isNodeMaterial&&F.setObject(E,Z),E.onBeforeRender(I,V,j,Y,Z,Tt),E.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),Z.onBeforeRender(I,V,j,Y,E,Tt),Z.transparent===!0&&Z.side===Fn&&Z.forceSinglePass===!1?(Z.side=$n,Z.needsUpdate=!0,I.renderBufferDirect(j,V,Y,Z,E,Tt),Z.side=Ws,Z.needsUpdate=!0,I.renderBufferDirect(j,V,Y,Z,E,Tt),Z.side=Fn):I.renderBufferDirect(j,V,Y,Z,E,Tt),E.onAfterRender(I,V,j,Y,Z,Tt)}function en(E){let V=0;for(let j of E)j.texture!==null&&V++;return V}function Di(E,V,j){V.isScene!==!0&&(V=pn);let Y=zt.get(E),Z=M.state.lights,Tt=M.state.shadowsArray,Pt=Z.state.version,Et=ot.getParameters(E,Z.state,Tt,V,j,M.state.lightProbeGridArray),It=ot.getProgramCacheKey(Et),Bt=Y.programs;Y.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?V.environment:null,Y.fog=V.fog;let te=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;Y.envMap=L.get(E.envMap||Y.environment,te),Y.envMapRotation=Y.environment!==null&&E.envMap===null?V.environmentRotation:E.envMapRotation,Bt===void 0&&(E.addEventListener("dispose",oe),Bt=new Map,Y.programs=Bt,Y.programVariants=new Map);let ue=Bt.get(It);if(ue!==void 0){if(Y.currentProgram===ue&&Y.lightsStateVersion===Pt)return No(E,Et),ue}else Et.uniforms=ot.getUniforms(E),F!==null&&E.isNodeMaterial&&F.build(E,j,Et),E.onBeforeCompile(Et,I),ue=ot.acquireProgram(Et,It),Bt.set(It,ue),Y.uniforms=Et.uniforms;let kt=Y.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(kt.clippingPlanes=st.uniform),No(E,Et),Y.needsLights=As(E),Y.lightsStateVersion=Pt,Y.needsLights&&(kt.ambientLightColor.value=Z.state.ambient,kt.lightProbe.value=Z.state.probe,kt.sunLights.value=Z.state.sun,kt.sunLightShadows.value=Z.state.sunShadow,kt.directionalLights.value=Z.state.directional,kt.directionalLightShadows.value=Z.state.directionalShadow,kt.spotLights.value=Z.state.spot,kt.spotLightShadows.value=Z.state.spotShadow,kt.rectAreaLights.value=Z.state.rectArea,kt.ltc_1.value=Z.state.rectAreaLTC1,kt.ltc_2.value=Z.state.rectAreaLTC2,kt.pointLights.value=Z.state.point,kt.pointLightShadows.value=Z.state.pointShadow,kt.hemisphereLights.value=Z.state.hemi,kt.sunShadowMatrix.value=Z.state.sunShadowMatrix,kt.sunShadowCascade.value=Z.state.sunShadowCascade,kt.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,kt.spotLightMatrix.value=Z.state.spotLightMatrix,kt.spotLightMap.value=Z.state.spotLightMap,kt.pointShadowMatrix.value=Z.state.pointShadowMatrix),Y.numLightProbeGrids=en(M.state.lightProbeGridArray),Y.currentProgram=ue,Y.uniformsList=null,ue}function jn(E,V,j,Y,Z){let Tt=zt.get(E),Pt=Tt.currentProgram.id+","+Y+","+Z,Et=Tt.programVariants.get(Pt);return Et===void 0?(Et=Di(E,V,j),Tt.programVariants.set(Pt,Et)):(Tt.currentProgram=Et,Tt.uniformsList=null,Tt.outputColorSpace=Y,Tt.toneMapping=Z),Et}function ws(E){if(E.uniformsList===null){let V=E.currentProgram.getUniforms();E.uniformsList=uo.seqWithValue(V.seq,E.uniforms)}return E.uniformsList}function No(E,V){let j=zt.get(E);j.outputColorSpace=V.outputColorSpace,j.batching=V.batching,j.batchingColor=V.batchingColor,j.instancing=V.instancing,j.instancingColor=V.instancingColor,j.instancingMorph=V.instancingMorph,j.skinning=V.skinning,j.morphTargets=V.morphTargets,j.morphNormals=V.morphNormals,j.morphColors=V.morphColors,j.morphTargetsCount=V.morphTargetsCount,j.numClippingPlanes=V.numClippingPlanes,j.numIntersection=V.numClipIntersection,j.vertexAlphas=V.vertexAlphas,j.vertexTangents=V.vertexTangents,j.toneMapping=V.toneMapping}function Do(E,V,j,Y,Z){V.isScene!==!0&&(V=pn),Xt.resetTextureUnits();let Tt=V.fog,Pt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?V.environment:null,Et=lt===null?I.outputColorSpace:lt.isXRRenderTarget===!0?lt.texture.colorSpace:_e.workingColorSpace,It=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Bt=L.get(Y.envMap||Pt,It),te=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,ue=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),kt=!!j.morphAttributes.position,de=!!j.morphAttributes.normal,qe=!!j.morphAttributes.color,Ee=Xi;Y.toneMapped&&(lt===null||lt.isXRRenderTarget===!0)&&(Ee=I.toneMapping);let Ce=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,mn=Ce!==void 0?Ce.length:0,Ut=zt.get(Y),an=M.state.lights;if(Oe===!0&&(rn===!0||E!==Q)){let Re=E===Q&&Y.id===K;st.setState(Y,E,Re)}let ge=!1,ts=!1;Y.version===Ut.__version?Ut.needsLights&&Ut.lightsStateVersion!==an.state.version||Z.isBatchedMesh&&Ut.batching===!1||!Z.isBatchedMesh&&Ut.batching===!0||Z.isBatchedMesh&&Ut.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ut.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ut.instancing===!1||!Z.isInstancedMesh&&Ut.instancing===!0||Z.isSkinnedMesh&&Ut.skinning===!1||!Z.isSkinnedMesh&&Ut.skinning===!0||Z.isInstancedMesh&&Ut.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Ut.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ut.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ut.instancingMorph===!1&&Z.morphTexture!==null||Ut.envMap!==Bt||Y.fog===!0&&Ut.fog!==Tt||Ut.numClippingPlanes!==void 0&&(Ut.numClippingPlanes!==st.numPlanes||Ut.numIntersection!==st.numIntersection)||Ut.vertexAlphas!==te||Ut.vertexTangents!==ue||Ut.morphTargets!==kt||Ut.morphNormals!==de||Ut.morphColors!==qe||Ut.morphTargetsCount!==mn||Ut.numLightProbeGrids!==en(M.state.lightProbeGridArray)?ge=!0:(Ut.outputColorSpace!==Et||Ut.toneMapping!==Ee)&&(ts=!0):(ge=!0,Ut.__version=Y.version);let ln=Ut.currentProgram;(ge===!0||ts===!0)&&(ln=ts===!0?jn(Y,V,Z,Et,Ee):Di(Y,V,Z),F&&Y.isNodeMaterial&&F.onUpdateProgram(Y,ln,Ut));let Tr=!1,Ui=!1,es=!1,le=ln.getUniforms(),Ke=Ut.uniforms;if(wt.useProgram(ln.program)&&(Tr=!0,Ui=!0,es=!0),Y.id!==K&&(K=Y.id,Ui=!0),Tr||Q!==E){wt.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),le.setValue(B,"projectionMatrix",E.projectionMatrix),le.setValue(B,"viewMatrix",E.matrixWorldInverse);let cn=le.map.cameraPosition;cn!==void 0&&cn.setValue(B,Mn.setFromMatrixPosition(E.matrixWorld)),re.logarithmicDepthBuffer&&le.setValue(B,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&le.setValue(B,"isOrthographic",E.isOrthographicCamera===!0),Q!==E&&(Q=E,Ui=!0,es=!0)}if(Ut.needsLights&&(an.state.sunShadowMap.length>0&&le.setValue(B,"sunShadowMap",an.state.sunShadowMap,Xt),an.state.directionalShadowMap.length>0&&le.setValue(B,"directionalShadowMap",an.state.directionalShadowMap,Xt),an.state.spotShadowMap.length>0&&le.setValue(B,"spotShadowMap",an.state.spotShadowMap,Xt),an.state.pointShadowMap.length>0&&le.setValue(B,"pointShadowMap",an.state.pointShadowMap,Xt)),Z.isSkinnedMesh){le.setOptional(B,Z,"bindMatrix"),le.setOptional(B,Z,"bindMatrixInverse");let Re=Z.skeleton;Re&&(Re.boneTexture===null&&Re.computeBoneTexture(),le.setValue(B,"boneTexture",Re.boneTexture,Xt))}Z.isBatchedMesh&&(le.setOptional(B,Z,"batchingTexture"),le.setValue(B,"batchingTexture",Z._matricesTexture,Xt),le.setOptional(B,Z,"batchingIdTexture"),le.setValue(B,"batchingIdTexture",Z._indirectTexture,Xt),le.setOptional(B,Z,"batchingColorTexture"),Z._colorsTexture!==null&&le.setValue(B,"batchingColorTexture",Z._colorsTexture,Xt));let zn=j.morphAttributes;if((zn.position!==void 0||zn.normal!==void 0||zn.color!==void 0)&&rt.update(Z,j,ln),(Ui||Ut.receiveShadow!==Z.receiveShadow)&&(Ut.receiveShadow=Z.receiveShadow,le.setValue(B,"receiveShadow",Z.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&V.environment!==null&&(Ke.envMapIntensity.value=V.environmentIntensity),Ke.dfgLUT!==void 0&&(Ke.dfgLUT.value=WM()),Ui){if(le.setValue(B,"toneMappingExposure",I.toneMappingExposure),Ut.needsLights&&wr(Ke,es),Tt&&Y.fog===!0&&xt.refreshFogUniforms(Ke,Tt),xt.refreshMaterialUniforms(Ke,Y,Mt,St,M.state.transmissionRenderTarget[E.id]),Ut.needsLights&&Ut.numLightProbeGrids>0){let Re=b,cn=0;for(let Nn of M.state.lightProbeGridArray)Nn.texture!==null&&(Re.textures[cn]=Nn.texture,Re.min[cn]=Nn.boundingBox.min,Re.max[cn]=Nn.boundingBox.max,Re.resolution[cn]=Nn.resolution,cn++);for(let Nn in Re)Re[Nn].length=cn;Ke.probesSH.value=Re.textures,Ke.probesMin.value=Re.min,Ke.probesMax.value=Re.max,Ke.probesResolution.value=Re.resolution}uo.upload(B,ws(Ut),Ke,Xt)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(uo.upload(B,ws(Ut),Ke,Xt),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&le.setValue(B,"center",Z.center),le.setValue(B,"modelViewMatrix",Z.modelViewMatrix),le.setValue(B,"normalMatrix",Z.normalMatrix),le.setValue(B,"modelMatrix",Z.matrixWorld),Y.uniformsGroups!==void 0){let Re=Y.uniformsGroups;for(let cn=0,Nn=Re.length;cn<Nn;cn++){let $a=Re[cn];Gt.update($a,ln),Gt.bind($a,ln)}}return ln}function wr(E,V){E.ambientLightColor.needsUpdate=V,E.lightProbe.needsUpdate=V,E.sunLights.needsUpdate=V,E.sunLightShadows.needsUpdate=V,E.directionalLights.needsUpdate=V,E.directionalLightShadows.needsUpdate=V,E.pointLights.needsUpdate=V,E.pointLightShadows.needsUpdate=V,E.spotLights.needsUpdate=V,E.spotLightShadows.needsUpdate=V,E.rectAreaLights.needsUpdate=V,E.hemisphereLights.needsUpdate=V}function As(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return lt},this.setRenderTargetTextures=function(E,V,j){let Y=zt.get(E);Y.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),zt.get(E.texture).__webglTexture=V,zt.get(E.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,V){let j=zt.get(E);j.__webglFramebuffer=V,j.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(E,V=0,j=0){lt=E,q=V,H=j;let Y=null,Z=!1,Tt=!1;if(E){let Et=zt.get(E);if(Et.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(B.FRAMEBUFFER,Et.__webglFramebuffer),it.copy(E.viewport),ft.copy(E.scissor),dt=E.scissorTest,wt.viewport(it),wt.scissor(ft),wt.setScissorTest(dt),K=-1;return}else if(Et.__webglFramebuffer===void 0)Xt.setupRenderTarget(E);else if(Et.__hasExternalTextures)Xt.rebindTextures(E,zt.get(E.texture).__webglTexture,zt.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let te=E.depthTexture;if(Et.__boundDepthTexture!==te){if(te!==null&&zt.has(te)&&(E.width!==te.image.width||E.height!==te.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xt.setupDepthRenderbuffer(E)}}let It=E.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(Tt=!0);let Bt=zt.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Bt[V])?Y=Bt[V][j]:Y=Bt[V],Z=!0):E.samples>0&&Xt.useMultisampledRTT(E)===!1?Y=zt.get(E).__webglMultisampledFramebuffer:Array.isArray(Bt)?Y=Bt[j]:Y=Bt,it.copy(E.viewport),ft.copy(E.scissor),dt=E.scissorTest}else it.copy(Vt).multiplyScalar(Mt).floor(),ft.copy(he).multiplyScalar(Mt).floor(),dt=ae;if(j!==0&&(Y=z),wt.bindFramebuffer(B.FRAMEBUFFER,Y)&&wt.drawBuffers(E,Y),wt.viewport(it),wt.scissor(ft),wt.setScissorTest(dt),Z){let Et=zt.get(E.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+V,Et.__webglTexture,j)}else if(Tt){let Et=V;for(let It=0;It<E.textures.length;It++){let Bt=zt.get(E.textures[It]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+It,Bt.__webglTexture,j,Et)}}else if(E!==null&&j!==0){let Et=zt.get(E.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Et.__webglTexture,j)}K=-1};function Ar(E){let V=zt.get(E);return(V.__readFormat!==E.format||V.__readType!==E.type)&&(V.__readFormat=E.format,V.__readType=E.type,V.__formatReadable=re.textureFormatReadable(E.format),V.__typeReadable=re.textureTypeReadable(E.type)),V}this.readRenderTargetPixels=function(E,V,j,Y,Z,Tt,Pt,Et=0){if(!(E&&E.isWebGLRenderTarget)){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=zt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It){wt.bindFramebuffer(B.FRAMEBUFFER,It);try{let Bt=E.textures[Et],te=Bt.format,ue=Bt.type;E.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Et);let kt=Ar(Bt);if(kt.__formatReadable===!1){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(kt.__typeReadable===!1){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=E.width-Y&&j>=0&&j<=E.height-Z&&B.readPixels(V,j,Y,Z,_t.convert(te),_t.convert(ue),Tt)}finally{let Bt=lt!==null?zt.get(lt).__webglFramebuffer:null;wt.bindFramebuffer(B.FRAMEBUFFER,Bt)}}},this.readRenderTargetPixelsAsync=async function(E,V,j,Y,Z,Tt,Pt,Et=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=zt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It)if(V>=0&&V<=E.width-Y&&j>=0&&j<=E.height-Z){wt.bindFramebuffer(B.FRAMEBUFFER,It);let Bt=E.textures[Et],te=Bt.format,ue=Bt.type;E.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Et);let kt=Ar(Bt);if(kt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(kt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let de=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,de),B.bufferData(B.PIXEL_PACK_BUFFER,Tt.byteLength,B.STREAM_READ),B.readPixels(V,j,Y,Z,_t.convert(te),_t.convert(ue),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let qe=lt!==null?zt.get(lt).__webglFramebuffer:null;wt.bindFramebuffer(B.FRAMEBUFFER,qe);let Ee=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await Yp(B,Ee,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,de),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Tt),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(de),B.deleteSync(Ee),Tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,V=null,j=0){let Y=Math.pow(2,-j),Z=Math.floor(E.image.width*Y),Tt=Math.floor(E.image.height*Y),Pt=V!==null?V.x:0,Et=V!==null?V.y:0;Xt.setTexture2D(E,0),B.copyTexSubImage2D(B.TEXTURE_2D,j,0,0,Pt,Et,Z,Tt),wt.unbindTexture()},this.copyTextureToTexture=function(E,V,j=null,Y=null,Z=0,Tt=0){let Pt,Et,It,Bt,te,ue,kt,de,qe,Ee=E.isCompressedTexture?E.mipmaps[Tt]:E.image;if(j!==null)Pt=j.max.x-j.min.x,Et=j.max.y-j.min.y,It=j.isBox3?j.max.z-j.min.z:1,Bt=j.min.x,te=j.min.y,ue=j.isBox3?j.min.z:0;else{let le=Math.pow(2,-Z);Pt=Math.floor(Ee.width*le),Et=Math.floor(Ee.height*le),E.isDataArrayTexture?It=Ee.depth:E.isData3DTexture?It=Math.floor(Ee.depth*le):It=1,Bt=0,te=0,ue=0}Y!==null?(kt=Y.x,de=Y.y,qe=Y.z):(kt=0,de=0,qe=0);let Ce=_t.convert(V.format),mn=_t.convert(V.type),Ut;V.isData3DTexture?(Xt.setTexture3D(V,0),Ut=B.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(Xt.setTexture2DArray(V,0),Ut=B.TEXTURE_2D_ARRAY):(Xt.setTexture2D(V,0),Ut=B.TEXTURE_2D),wt.activeTexture(B.TEXTURE0),wt.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,V.flipY),wt.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),wt.pixelStorei(B.UNPACK_ALIGNMENT,V.unpackAlignment);let an=wt.getParameter(B.UNPACK_ROW_LENGTH),ge=wt.getParameter(B.UNPACK_IMAGE_HEIGHT),ts=wt.getParameter(B.UNPACK_SKIP_PIXELS),ln=wt.getParameter(B.UNPACK_SKIP_ROWS),Tr=wt.getParameter(B.UNPACK_SKIP_IMAGES);wt.pixelStorei(B.UNPACK_ROW_LENGTH,Ee.width),wt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Ee.height),wt.pixelStorei(B.UNPACK_SKIP_PIXELS,Bt),wt.pixelStorei(B.UNPACK_SKIP_ROWS,te),wt.pixelStorei(B.UNPACK_SKIP_IMAGES,ue);let Ui=E.isDataArrayTexture||E.isData3DTexture,es=V.isDataArrayTexture||V.isData3DTexture;if(E.isDepthTexture){let le=zt.get(E),Ke=zt.get(V),zn=zt.get(le.__renderTarget),Re=zt.get(Ke.__renderTarget);wt.bindFramebuffer(B.READ_FRAMEBUFFER,zn.__webglFramebuffer),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,Re.__webglFramebuffer);for(let cn=0;cn<It;cn++)Ui&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,zt.get(E).__webglTexture,Z,ue+cn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,zt.get(V).__webglTexture,Tt,qe+cn)),B.blitFramebuffer(Bt,te,Bt+Pt,te+Et,kt,de,kt+Pt,de+Et,B.DEPTH_BUFFER_BIT,B.NEAREST);wt.bindFramebuffer(B.READ_FRAMEBUFFER,null),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(Z!==0||E.isRenderTargetTexture||zt.has(E)){let le=zt.get(E),Ke=zt.get(V);wt.bindFramebuffer(B.READ_FRAMEBUFFER,U),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,G);for(let zn=0;zn<It;zn++)Ui?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,le.__webglTexture,Z,ue+zn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,le.__webglTexture,Z),es?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ke.__webglTexture,Tt,qe+zn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Ke.__webglTexture,Tt),Z!==0?B.blitFramebuffer(Bt,te,Bt+Pt,te+Et,kt,de,kt+Pt,de+Et,B.COLOR_BUFFER_BIT,B.NEAREST):es?B.copyTexSubImage3D(Ut,Tt,kt,de,qe+zn,Bt,te,Pt,Et):B.copyTexSubImage2D(Ut,Tt,kt,de,Bt,te,Pt,Et);wt.bindFramebuffer(B.READ_FRAMEBUFFER,null),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else es?E.isDataTexture||E.isData3DTexture?B.texSubImage3D(Ut,Tt,kt,de,qe,Pt,Et,It,Ce,mn,Ee.data):V.isCompressedArrayTexture?B.compressedTexSubImage3D(Ut,Tt,kt,de,qe,Pt,Et,It,Ce,Ee.data):B.texSubImage3D(Ut,Tt,kt,de,qe,Pt,Et,It,Ce,mn,Ee):E.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Tt,kt,de,Pt,Et,Ce,mn,Ee.data):E.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Tt,kt,de,Ee.width,Ee.height,Ce,Ee.data):B.texSubImage2D(B.TEXTURE_2D,Tt,kt,de,Pt,Et,Ce,mn,Ee);wt.pixelStorei(B.UNPACK_ROW_LENGTH,an),wt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,ge),wt.pixelStorei(B.UNPACK_SKIP_PIXELS,ts),wt.pixelStorei(B.UNPACK_SKIP_ROWS,ln),wt.pixelStorei(B.UNPACK_SKIP_IMAGES,Tr),Tt===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&B.generateMipmap(Ut),wt.unbindTexture()},this.initRenderTarget=function(E){zt.get(E).__webglFramebuffer===void 0&&Xt.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Xt.setTextureCube(E,0):E.isData3DTexture?Xt.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Xt.setTexture2DArray(E,0):Xt.setTexture2D(E,0),wt.unbindTexture()},this.resetState=function(){q=0,H=0,lt=null,wt.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return gi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=_e._getDrawingBufferColorSpace(t),e.unpackColorSpace=_e._getUnpackColorSpace()}};function pr(n){let t=new ps;return n===0||(t.onBeforeCompile=e=>{e.vertexShader=e.vertexShader.replace("#include <project_vertex>",`#include <project_vertex>
      vec4 pulled = vec4(mvPosition.xyz - normalize(mvPosition.xyz) * ${n.toExponential()}, 1.0);
      vec4 there = projectionMatrix * pulled;
      gl_Position.z = there.z / there.w * gl_Position.w;`)},t.customProgramCacheKey=()=>`nearer ${n}`),t}function po(n,t,e,i,s,r){let o=n[e]-n[t],a=n[e+1]-n[t+1],l=n[e+2]-n[t+2],c=Math.hypot(o,a,l)||1e-12;o/=c,a/=c,l/=c;let h=Math.abs(l)<.9,[u,d,f]=h?[a,-o,0]:[0,l,-a],m=Math.hypot(u,d,f);u/=m,d/=m,f/=m,s[r]=i*u,s[r+1]=i*d,s[r+2]=i*f,s[r+4]=c*o,s[r+5]=c*a,s[r+6]=c*l,s[r+8]=i*(d*l-f*a),s[r+9]=i*(f*o-u*l),s[r+10]=i*(u*a-d*o);for(let _=0;_<3;_++)s[r+12+_]=(n[t+_]+n[e+_])/2;s[r+15]=1}var qc="#d55e00",Yc="#0072b2",Dm=["#e2cf9f","#c5bcd9","#b7cfa2","#d6aeb9","#9cc4dd","#cfcfcf"];function Ia(n){return Dm[n%Dm.length]}var XM=["#453781","#39568c","#2d708e","#20908d","#29af7f","#73d055","#b8de29","#fde725"],$M=["#00224e","#083370","#35456c","#4f576c","#666970","#7d7c78","#948e77","#aea371","#c8b866","#e5cf52","#fee838"],qM=["#ffffcc","#ffeda0","#fed976","#feb24c","#fd8c3c","#fc4d2a","#e2191c","#bb0026","#800026"];function cd(n){let t=n.map(i=>[1,3,5].map(s=>parseInt(i.slice(s,s+2),16)/255));function e(i,s=[0,0,0]){let r=Math.min(1,Math.max(0,i))*(n.length-1),o=Math.min(n.length-2,Math.floor(r));for(let a=0;a<3;a++){let l=t[o][a];s[a]=l+(r-o)*(t[o+1][a]-l)}return s}return{at:e,gradient:`linear-gradient(to right, ${n.join(", ")})`}}var mo=cd(XM),Om=cd($M),Zc=cd(qM);function Fe(n){return getComputedStyle(document.documentElement).getPropertyValue(n).trim()}function $s(n){let t=matchMedia("(prefers-color-scheme: dark)");return t.addEventListener("change",n),()=>t.removeEventListener("change",n)}var Um=[[],[8,4],[8,3,2,3],[2,3]],YM=7;function xs(n){return{colour:Fe(`--line-${n%YM}`),dash:Um[n%Um.length]}}var ZM=32767,qs=24,KM=5/3*Math.PI,JM=.22,hd=.11,Fm=.7,km=3,Bm=1e-6;function zm(n){let t=n.turns.map(l=>({...l,pivot:dn(l.pivot,Float32Array),axis:Float32Array.from(dn(l.axis,Int16Array),c=>c/ZM),left:l.left&&dn(l.left,Float32Array)})),e=n.pushes.map(l=>({...l,force:l.force&&dn(l.force,Float32Array)})),{drives:i,stages:s}=n;function r(l){let c=s.find(({start:h,end:u})=>l>h&&l<=u);return i.map(({strength:h,rise:u},d)=>c?.drives.includes(d)?h*(u>0?Math.min(1,(l-c.start)/u):1):0)}let o=(l,c)=>l.reduce((h,u,d)=>h+u*c[d],0),a=l=>l.reduce((c,{shares:h})=>{let u=s.map(d=>Math.abs(o(h,i.map(({strength:f},m)=>d.drives.includes(m)?f:0))));return Math.max(c,...u)},0);return{...n,time:dn(n.time,Float64Array),turns:t,pushes:e,strengthsAt:r,summed:o,largestTurn:a(t),largestPush:a(e)}}function Vm({drives:n,strengthsAt:t},e,i){let s=t(e);return n.flatMap(({text:r,unit:o,factor:a},l)=>s[l]?[`${r}: ${i(a*s[l])} ${o}`]:[])}function Gm(n){let{time:t,turns:e,pushes:i,strengthsAt:s,summed:r,largestTurn:o,largestPush:a}=n.efforts,l=Math.max(0,...e.map(P=>P.radius)),c=.05*n.mesh.span_m,h=pr(Math.max(l,c)),u=new li(new Hi(1,1,1,10),h,e.length*qs+i.length),d=new li(new la(1,1,16),h,e.length+i.length),f=new On;for(let P of[u,d])P.frustumCulled=!1,f.add(P);let m=new Float32Array(3*(qs+2)),[_,p]=[0,0],g=(P,I,R,F,z)=>po(m,3*I,3*R,F,P.instanceMatrix.array,16*z);function x(P,I){for(let R=0;R<3;R++)m[3*P+R]=I[R]}function A(P,I,R,F){let[z,U]=Yi(t,R),q=(P.left?ud(P.left,1,z,U)[0]:1)*r(P.shares,F)/o;if(!(Math.abs(q)>Bm))return;let[H,lt]=P.ends?jM(I,P.ends):[P.pivot,P.axis].map(ut=>ud(ut,3,z,U)),K=tw(lt,P),Q=QM(lt,K),it=KM*Math.min(1.2,Math.abs(q))*Math.sign(q),ft=ut=>H.map((gt,St)=>gt+P.radius*(Math.cos(ut)*K[St]+Math.sin(ut)*Q[St]));for(let ut=0;ut<=qs;ut++)x(ut,ft(it*(ut/qs-.5)));let dt=it/2;x(qs+1,ft(dt+Math.sign(q)*Fm));let tt=hd*P.radius;for(let ut=0;ut<qs;ut++)g(u,ut,ut+1,tt,_++);g(d,qs,qs+1,km*tt,p++)}function b(P,I,R,F){let[z,U]=Yi(t,R),G=P.force?ud(P.force,1,z,U)[0]:r(P.shares,F)/a;if(!(Math.abs(G)>Bm))return;let q=JM*n.mesh.span_m*G,H=I.subarray(3*P.point,3*P.point+3),lt=K=>P.direction.map((Q,it)=>H[it]+K*Q);x(0,H),x(1,lt(q)),x(2,lt(q+Math.sign(G)*Fm*c)),g(u,0,1,hd*c,_++),g(d,1,2,km*hd*c,p++)}function C(P){[_,p]=[0,0];let I=s(P),R=n.pointsAt(P);for(let F of e)A(F,R,P,I);for(let F of i)b(F,R,P,I);[u.count,d.count]=[_,p];for(let F of[u,d])F.instanceMatrix.needsUpdate=!0}let M=()=>h.color.set(new Qt(Fe("--effort")));function y(){for(let P of[u,d])P.dispose(),P.geometry.dispose();h.dispose()}return{group:f,pose:C,paint:M,count:()=>p,dispose:y}}function ud(n,t,e,i){if(n.length===t)return Array.from(n);let s=Math.min(e+1,n.length/t-1);return Array.from({length:t},(r,o)=>{let a=n[e*t+o];return a+i*(n[s*t+o]-a)})}function jM(n,[t,e]){let[i,s]=[t,e].map(a=>Array.from(n.subarray(3*a,3*a+3))),r=i.map((a,l)=>s[l]-a),o=Math.hypot(...r)||1;return[i.map((a,l)=>(a+s[l])/2),r.map(a=>a/o)]}function QM(n,t){return[0,1,2].map(e=>n[(e+1)%3]*t[(e+2)%3]-n[(e+2)%3]*t[(e+1)%3])}function tw(n,t){t.side??=n.map(Math.abs).reduce((r,o,a,l)=>o<l[r]-.001?a:r,2);let e=n[t.side],i=n.map((r,o)=>(o===t.side?1:0)-e*r),s=Math.hypot(...i)||1;return i.map(r=>r/s)}var mr="tendon energy";function dn(n,t){let e=atob(n),i=new Uint8Array(e.length);for(let s=0;s<e.length;s++)i[s]=e.charCodeAt(s);return new t(i.buffer)}function Ys(n){let t=dn(n.time,Float64Array),e=dn(n.points,Float32Array),i=3*n.pointCount,s={[mr]:{width:n.tendonParts.length,values:dn(n.tendonEnergy_J,Float32Array)}};for(let p of n.readings)s[p.name]={width:p.parts.length,values:dn(p.values,Float32Array)};let r=Int32Array.from(n.between),o=Float64Array.from(n.share),a=new Float32Array(i);function l(p,g=a){return dd(t,e,i,p,g),g}function c(p,g=new Float32Array(3*o.length)){return h(l(p),g)}function h(p,g){for(let x=0;x<o.length;x++){let A=3*r[2*x],b=3*r[2*x+1];for(let C=0;C<3;C++){let M=p[A+C];g[3*x+C]=M+o[x]*(p[b+C]-M)}}return g}function u(p,g,x=new Float32Array(s[p].width)){return dd(t,s[p].values,s[p].width,g,x),x}function d(p,g){let{width:x,values:A}=s[p];return Float32Array.from(t,(b,C)=>A[C*x+g])}let f=dn(n.restLength_m,Float32Array);function m(p,g){f.length===g.length?g.set(f):dd(t,f,g.length,p,g)}let _=n.efforts&&zm(n.efforts);return{name:n.name,reach:Math.max(n.base.radius,_?.pushes.length?.12*n.span_m:0,...(_?.turns??[]).map(p=>.4*p.radius)),mesh:n,marks:n.marks,stages:n.stages,tendons:n.tendonParts.length,readings:n.readings,time:t,start:t[0],end:t[t.length-1],efforts:_,strained:n.built!==null,builtVertices:()=>h(dn(n.built,Float32Array),new Float32Array(3*o.length)),restLengthsAt:m,pointsAt:l,verticesAt:c,valuesAt:u,line:d,stageAt:p=>n.stages.findLast(g=>g.start<=p)??n.stages[0],markAt:p=>n.marks.find(g=>Math.abs(g.time-p)<1e-9)}}function dd(n,t,e,i,s){let[r,o]=Yi(n,i),a=r*e,l=Math.min(r+1,n.length-1)*e;for(let c=0;c<e;c++){let h=t[a+c];s[c]=o===0?h:h+o*(t[l+c]-h)}}function Yi(n,t){if(!(t>n[0]))return[0,0];let e=n.length-1;if(t>=n[e])return[e,0];let i=0,s=e;for(;s-i>1;){let r=i+s>>1;n[r]<=t?i=r:s=r}return[i,(t-n[i])/(n[i+1]-n[i])]}var ew=.3,nw=4,iw=4,Wm=[{name:"even motion",value:"even"},{name:"real time",value:1},{name:"1/2",value:1/2},{name:"1/5",value:1/5},{name:"1/10",value:1/10},{name:"1/20",value:1/20},{name:"1/50",value:1/50},{name:"1/100",value:1/100}];function Xm(n,t){let e=sw(n,t),i=new Float64Array(e.length);for(let[l,c]of n.entries())rw(c,t.origins[l],e,i);for(let l=1;l<i.length;l++)i[l]+=i[l-1];let s=i[i.length-1],r=s>0?ew:1;for(let l=0;l<i.length;l++){let c=(e[l]-e[0])/(e[e.length-1]-e[0]||1);i[l]=r*c+(1-r)*(i[l]/(s||1))}let o=l=>l.drive!=="none"&&l.start-t.origins[0]<t.end&&l.end-t.origins[0]>t.start,a=n[0].stages.filter(o).length;return{seconds:nw+iw*a,wayAt:l=>Hm(e,i,l),timeAt:l=>Hm(i,e,l)}}function sw(n,t){let e=new Set([t.start,t.end]);for(let[i,s]of n.entries())for(let r of s.time){let o=r-t.origins[i];o>t.start&&o<t.end&&e.add(o)}return Float64Array.from(e).sort()}function rw(n,t,e,i){let s=n.pointsAt(e[0]+t).slice(),r=s.slice();for(let o=1;o<e.length;o++){n.pointsAt(e[o]+t,r);let a=0;for(let l=0;l<r.length;l+=3){let c=Math.hypot(r[l]-s[l],r[l+1]-s[l+1],r[l+2]-s[l+2]);c>a&&(a=c)}i[o]=Math.max(i[o],a),[s,r]=[r,s]}}function Hm(n,t,e){let[i,s]=Yi(n,e);return s===0?t[i]:t[i]+s*(t[i+1]-t[i])}var ow=200;function ys(n,t){let e=new Set,i=t[0].start,s=t[0],r="even",o=!1,a=0,l=0,c=new Map;function h(){return c.has(s)||c.set(s,Xm(n,s)),c.get(s)}let u=()=>r==="even"&&s.whole;function d(x){return u()?h().wayAt(x):(x-s.start)/(s.end-s.start||1)}function f(x){return u()?h().timeAt(x):s.start+x*(s.end-s.start)}function m(){l||(l=requestAnimationFrame(_))}function _(x){if(l=0,o){let A=Math.min((x-a)/1e3,.1);a=x,p(A),l=requestAnimationFrame(_)}for(let A of e)A()}function p(x){r==="even"?i=h().timeAt(Math.min(1,h().wayAt(i)+x/h().seconds)):i=Math.min(s.end,i+r*x),i>=s.end&&(o=!1)}function g(x){i=Math.min(s.end,Math.max(s.start,x)),m()}return{get time(){return i},get span(){return s},get speed(){return r},get playing(){return o},spans:t,clipTime:(x,A=i)=>Math.min(n[x].end,Math.max(n[x].start,A+s.origins[x])),get stretched(){return u()},shareAt:d,momentAt:f,wayAt:x=>h().wayAt(x),timeAt:x=>h().timeAt(x),get slowness(){if(r!=="even")return 1/r;let x=h().wayAt(i),[A,b]=[Math.max(0,x-5e-4),Math.min(1,x+5e-4)];return(b-A)*h().seconds/(h().timeAt(b)-h().timeAt(A)||1e-12)},onChange(x){return e.add(x),m(),()=>e.delete(x)},seek:g,seekClip(x,A){(A<s.start+s.origins[x]||A>s.end+s.origins[x])&&(s=t.find(b=>A>=b.start+b.origins[x]&&A<=b.end+b.origins[x])??t[0]),g(A-s.origins[x])},step:x=>g(f(d(i)+x/ow)),play(){i>=s.end&&(i=s.start),o=!0,a=performance.now(),m()},pause(){o=!1,m()},setSpeed(x){r=x,m()},setSpan(x){s=x,g(i<s.start||i>s.end?s.start:i)},redraw:m}}function Zi(n){return`${n[0]?.toUpperCase()??""}${n.slice(1)}`}function qn(n,t){let e=n.toFixed(t);return(Number(e)===0?0 .toFixed(t):e).replace("-","−")}function yn(n){let t=Number(n.toPrecision(4)),e=Math.abs(t);return(e!==0&&(e>=1e5||e<.001)?n.toExponential(2):String(t)).replaceAll("-","−")}function La(n){let t=Math.max(Math.abs(n.start),Math.abs(n.end));return t>=.2?{unit:"s",factor:1}:t>=2e-4?{unit:"ms",factor:1e3}:{unit:"µs",factor:1e6}}function Na(n,t){let{unit:e,factor:i}=La(t),s=Math.ceil(2.7-Math.log10(i*(t.end-t.start)));return`${qn(i*n,Math.min(6,Math.max(0,s)))} ${e}`}var $m={type:"change"},pd={type:"start"},Ym={type:"end"},Kc=new Os,qm=new ri,aw=Math.cos(70*Yu.DEG2RAD),vn=new X,Jn=2*Math.PI,Me={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},fd=1e-6,Jc=class extends _a{constructor(t,e=null){super(t,e),this.state=Me.NONE,this.target=new X,this.cursor=new X,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Gs.ROTATE,MIDDLE:Gs.DOLLY,RIGHT:Gs.PAN},this.touches={ONE:Hs.ROTATE,TWO:Hs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new X,this._lastQuaternion=new oi,this._lastTargetPosition=new X,this._quat=new oi().setFromUnitVectors(t.up,new X(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new ro,this._sphericalDelta=new ro,this._scale=1,this._panOffset=new X,this._rotateStart=new Yt,this._rotateEnd=new Yt,this._rotateDelta=new Yt,this._panStart=new Yt,this._panEnd=new Yt,this._panDelta=new Yt,this._dollyStart=new Yt,this._dollyEnd=new Yt,this._dollyDelta=new Yt,this._dollyDirection=new X,this._mouse=new Yt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=cw.bind(this),this._onPointerDown=lw.bind(this),this._onPointerUp=hw.bind(this),this._onContextMenu=_w.bind(this),this._onMouseWheel=fw.bind(this),this._onKeyDown=pw.bind(this),this._onTouchStart=mw.bind(this),this._onTouchMove=gw.bind(this),this._onMouseDown=uw.bind(this),this._onMouseMove=dw.bind(this),this._interceptControlDown=xw.bind(this),this._interceptControlUp=yw.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Me.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent($m),this.update(),this.state=Me.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;vn.copy(e).sub(this.target),vn.applyQuaternion(this._quat),this._spherical.setFromVector3(vn),this.autoRotate&&this.state===Me.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Jn:i>Math.PI&&(i-=Jn),s<-Math.PI?s+=Jn:s>Math.PI&&(s-=Jn),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(vn.setFromSpherical(this._spherical),vn.applyQuaternion(this._quatInverse),e.copy(this.target).add(vn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=vn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new X(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new X(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=vn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Kc.origin.copy(this.object.position),Kc.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Kc.direction))<aw?this.object.lookAt(this.target):(qm.setFromNormalAndCoplanarPoint(this.object.up,this.target),Kc.intersectPlane(qm,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>fd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>fd||this._lastTargetPosition.distanceToSquared(this.target)>fd?(this.dispatchEvent($m),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Jn/60*this.autoRotateSpeed*t:Jn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){vn.setFromMatrixColumn(e,0),vn.multiplyScalar(-t),this._panOffset.add(vn)}_panUp(t,e){this.screenSpacePanning===!0?vn.setFromMatrixColumn(e,1):(vn.setFromMatrixColumn(e,0),vn.crossVectors(this.object.up,vn)),vn.multiplyScalar(t),this._panOffset.add(vn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;vn.copy(s).sub(this.target);let r=vn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Jn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Jn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Jn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Jn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Yt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function lw(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function cw(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function hw(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Ym),this.state=Me.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function uw(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Gs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Me.DOLLY;break;case Gs.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Me.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Me.ROTATE}break;case Gs.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Me.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Me.PAN}break;default:this.state=Me.NONE}this.state!==Me.NONE&&this.dispatchEvent(pd)}function dw(n){switch(this.state){case Me.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Me.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Me.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function fw(n){this.enabled===!1||this.enableZoom===!1||this.state!==Me.NONE||(n.preventDefault(),this.dispatchEvent(pd),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Ym))}function pw(n){this.enabled!==!1&&this._handleKeyDown(n)}function mw(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Hs.ROTATE:if(this.enableRotate===!1){this.state=Me.NONE;break}this._handleTouchStartRotate(n),this.state=Me.TOUCH_ROTATE;break;case Hs.PAN:if(this.enablePan===!1){this.state=Me.NONE;break}this._handleTouchStartPan(n),this.state=Me.TOUCH_PAN;break;default:this.state=Me.NONE}break;case 2:switch(this.touches.TWO){case Hs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Me.TOUCH_DOLLY_PAN;break;case Hs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Me.TOUCH_DOLLY_ROTATE;break;default:this.state=Me.NONE}break;default:this.state=Me.NONE}this.state!==Me.NONE&&this.dispatchEvent(pd)}function gw(n){switch(this._trackPointer(n),this.state){case Me.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Me.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Me.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Me.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Me.NONE}}function _w(n){this.enabled!==!1&&n.preventDefault()}function xw(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function yw(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var md=120,Zm=2,Km=6;function gd(n,t,e){let i=new WeakMap,s=t.reduce((l,c)=>n[c].mesh.tubes.reduce((h,u)=>Math.max(h,u.radius),Math.max(l,n[c].reach)),Math.max(...t.map(l=>n[l].mesh.joints.length?n[l].mesh.jointRadius:0))),r=null;function o(){let{span:l}=e;if(!i.has(l)){let c=Array.from({length:md+1},(h,u)=>e.timeAt(u/md));i.set(l,c.map(h=>t.map(u=>n[u].pointsAt(e.clipTime(u,h)).slice())))}return i.get(l)}function a(l,c){let h=[...l.flatMap(d=>d.toArray()),...c].join();if(r?.key===h&&r.span===e.span)return r;let u=o().map(d=>vw(d,l,c,s));return r={key:h,span:e.span,rows:bw(u),whole:Jm(u)},r}return function(c,h,u,d){let f=new X().crossVectors(h,c).normalize(),m=[f,new X().crossVectors(c,f),c],{rows:_,whole:p}=a(m,u),g=d?Sw(_,e.wayAt(e.time)*md):p,[x,A,b,C,M,y]=g,S=[(x-A)/2,(b-C)/2,(M-y)/2],P=Math.max((x+A)/(2*u[0]),(b+C)/(2*u[1])),I=new X;for(let[R,F]of m.entries())I.addScaledVector(F,S[R]);return{target:I,distance:P-S[2]||1}}}function vw(n,t,e,i){let s=new Float64Array(Km).fill(-1/0),r=e.map(u=>i*Math.hypot(1,u)),o=[r[0],r[0],r[1],r[1],0,0],[a,l,c]=t.map(u=>u.toArray()),h=(u,d,f)=>u[0]*d[f]+u[1]*d[f+1]+u[2]*d[f+2];for(let u of n)for(let d=0;d<u.length;d+=3){let[f,m,_]=[h(a,u,d),h(l,u,d),h(c,u,d)],[p,g]=[e[0]*_,e[1]*_],x=[f+p,p-f,m+g,g-m,_,-_];for(let A=0;A<Km;A++)x[A]>s[A]&&(s[A]=x[A])}return s.map((u,d)=>u+o[d])}function Jm(n){return n.reduce((t,e)=>t.map((i,s)=>Math.max(i,e[s])))}function bw(n){let t=(i,s)=>i.slice(Math.max(0,s-Zm),s+Zm+1),e=n.map((i,s)=>Jm(t(n,s)));return n.map((i,s)=>{let r=t(e,s);return r[0].map((o,a)=>r.reduce((l,c)=>l+c[a],0)/r.length)})}function Sw(n,t){let e=Math.min(n.length-2,Math.max(0,Math.floor(t))),i=Math.min(1,Math.max(0,t-e));return n[e].map((s,r)=>s+i*(n[e+1][r]-s))}var jm=28,Mw=1.05,Qm=Math.PI/24,ww=1.15,gr=[{name:"3-D",text:"obliquely from above",towards:[.37,-.695,.616]},{name:"top",text:"from above",towards:[0,-5e-4,1]},{name:"side",text:"from the side, level with what lies flat",towards:[0,-1,1e-4]},{name:"along",text:"from the far end, along the middle",towards:[1,0,1e-4]}];function tg(n,t,e,i,s=_d()){let{size:r,target:o}=Aw(t),a=t.map((C,M)=>M),l=gd(t,a,e),c=a.map(C=>gd(t,[C],e)),h=new Wn(jm,1,.02*r,60*r);h.up.set(0,0,1);let u=new Jc(h,n);u.minDistance=.1*r,u.maxDistance=20*r;let d=null;function f(C=0){let M=s.oneScale?l:c[C],y=Math.tan(jm*Math.PI/360)/Mw;d=M(s.towards,h.up,[y*h.aspect,y],s.following),s.oneScale&&(d.distance*=s.scale),u.target.copy(d.target).addScaledVector(s.aside,d.distance),h.position.copy(u.target).addScaledVector(s.towards,s.closer*d.distance),h.lookAt(u.target),h.updateMatrixWorld()}function m(){f(),i()}u.addEventListener("change",()=>{let C=h.position.clone().sub(u.target);s.closer=C.length()/d.distance,s.towards.copy(C).normalize(),s.aside.copy(u.target).sub(d.target).divideScalar(d.distance),m()});let _=C=>{document.activeElement!==n&&!C.ctrlKey&&C.stopImmediatePropagation()};n.parentElement.addEventListener("wheel",_,{capture:!0});function p({towards:C}){s.towards.set(...C).normalize(),s.closer=1,s.aside.set(0,0,0),m()}function g(C,M){let y=s.towards.clone().applyAxisAngle(h.up,C*Qm),S=new X().crossVectors(h.up,y).normalize(),P=y.clone().applyAxisAngle(S,-M*Qm);s.towards.copy(Math.abs(P.z)<.9999?P:y),m()}function x(C){let M=s.closer*d.distance*ww**-C;s.closer=Math.min(u.maxDistance,Math.max(u.minDistance,M))/d.distance,m()}function A(C){Object.assign(s,C),m()}function b(C,M){h.aspect=C,h.updateProjectionMatrix(),u.rotateSpeed=M,u.panSpeed=M,m()}return{camera:h,controls:u,look:s,size:r,target:o,aim:f,show:p,turn:g,zoom:x,choose:A,resize:b,dispose:()=>u.dispose()}}function _d(){return{towards:new X(...gr[0].towards).normalize(),closer:1,aside:new X,following:!0,oneScale:!0,scale:1}}function Aw(n){let t=new X(1/0,1/0,1/0),e=new X(-1/0,-1/0,-1/0),i=new X;for(let r of n){let o=Math.max(1,Math.floor(r.time.length/60));for(let a=0;a<r.time.length;a+=o){let l=r.pointsAt(r.time[a]);for(let c=0;c<l.length;c+=3)i.fromArray(l,c),t.min(i),e.max(i)}}let s=t.clone().add(e).multiplyScalar(.5);return{target:s,size:e.distanceTo(s)||1}}var Tw=[["space","play or pause"],["← →","a little back or on"],["page down, page up","further back or on"],["home, end","start, end"]],Ew="shift with ← → ↑ ↓",Cw=[["+ −","nearer, further"],["0","the first view again"]];function jc(n,t,e){let s=(n.length===1?n[0].marks:[]).map((o,a)=>[String(a+1),o.name]),r=[...Tw,...s,...t?[[Ew,`turn the ${e}`],...Cw]:[]].map(([o,a])=>N("tr",{},N("th",{scope:"row"},o),N("td",{},a)));return N("details",{className:"keys"},N("summary",{},"Keys"),N("table",{},N("tbody",{},...r)),N("p",{},"Space and arrows act wherever nothing else on the page has the keys, the others in the player."))}var eg={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function ng({key:n,shiftKey:t},e,i,s){if(t&&n in eg)e?.turn(...eg[n]);else if(s)if(n==="+"||n==="=")e?.zoom(1);else if(n==="-"||n==="−")e?.zoom(-1);else if(n==="0")e?.show(i);else return!1;else return!1;return!0}function ig(n,t,e){n.addEventListener("keydown",i=>{!i.ctrlKey&&!i.metaKey&&!i.altKey&&ng(i,t,e,!0)&&i.preventDefault()})}function Qc(n,t,e,i,s){let r={ArrowLeft:-1,ArrowRight:1,PageUp:10,PageDown:-10};function o(c){e.pause(),c()}function a(c,h){let{key:u}=c;if(ng(c,i,s,h))return!0;if(u in r)o(()=>e.step(r[u]));else if(u===" ")e.playing?e.pause():e.play();else if(u==="Home")o(()=>e.seek(e.span.start));else if(u==="End")o(()=>e.seek(e.span.end));else if(h)if(t.length===1&&t[0].marks[Number(u)-1])o(()=>e.seekClip(0,t[0].marks[Number(u)-1].time));else return!1;else return!1;return!0}function l(c){let h=document.activeElement,u=n.contains(h);!(u||h===document.body||h===null)||c.ctrlKey||c.metaKey||c.altKey||h instanceof HTMLSelectElement||h?.dataset?.keys==="own"||c.key===" "&&/^(BUTTON|SUMMARY|A)$/.test(h?.tagName??"")||h===document.body&&/^(Home|End|PageUp|PageDown)$/.test(c.key)||a(c,u)&&c.preventDefault()}return document.addEventListener("keydown",l),()=>document.removeEventListener("keydown",l)}var sg=2.4;function Da(n){let t=10**Math.floor(Math.log10(n/sg));return t*[5,2,1].find(e=>e*t<=n/sg)}function rg(n,t){let e=Da(n),i=e*Math.ceil(1.25*n/e),s=[],[r,o]=[t.x,t.y].map(c=>e*Math.round(c/e));for(let c=-i;c<=i+e/2;c+=e)s.push(r+c,o-i,0,r+c,o+i,0,r-i,o+c,0,r+i,o+c,0);let a=new gn().setAttribute("position",new Qe(s,3)),l=new lr(a,new ks({transparent:!0,opacity:.5,depthWrite:!1}));return l.frustumCulled=!1,l}function xd(n,t,e,i){let s=i?["marks on the time line: the states of each run, in its colour"]:[];return N("ul",{className:"legend"},...n.map(({sample:r,text:o})=>r==="tendon"?Pw(o,t):Rw(r,o)),...n.some(({sample:r})=>r==="tendon")?[N("li",{},"slack tendons hang, drawn with their resting length")]:[],N("li",{},`squares of the grid: ${Iw(Da(e))}`),...s.map(r=>N("li",{},r)))}function Rw(n,t){let[e,i]=n.split(" "),s={mountain:{color:qc},valley:{color:Yc},region:{background:Ia(i)}};return N("li",{className:e==="region"?"of-region":""},og(e==="region"?"panel":e,s[e]??{}),t)}function Pw(n,t){let e=N("li",{className:"energy"},`${n}: 0`,yd(mo));return e.append(`${yn(t.factor*t.largest_J)} ${t.unit}`),e}function yd(n){return og("bar",{background:n.gradient})}function og(n,t){let e=N("span",{className:`swatch ${n}`,"aria-hidden":"true"});return Object.assign(e.style,t),e}function Iw(n){let[t,e]=n>=1?["m",1]:n>=.01?["cm",100]:n>=1e-4?["mm",1e3]:["µm",1e6];return`${yn(e*n)} ${t}`}function ag(n,t){if(!(t>n*(1+1e-6)))return 0;let[e,i]=[0,t/2];for(let s=0;s<40;s++){let r=(e+i)/2;Lw(n,r)<t?e=r:i=r}return(e+i)/2}function Lw(n,t){return t===0?n:Math.hypot(n,4*t)/2+n*n*Math.asinh(4*t/(n||1e-12))/(8*t)}function cg(n){let{triangles:t,faces:e}=n.mesh,i=n.builtVertices(),s=Array.from({length:e.length},(c,h)=>lg(i,t,h)),r=new Float32Array(e.reduce((c,h)=>Math.max(c,h),0)+1),o=new Float32Array(e.length);function a(c){r.fill(-1/0);for(let h=0;h<e.length;h++){let[u,d,f]=s[h],m=u*f-d*d;if(m<=1e-9*(u+f)**2)continue;let[_,p,g]=lg(c,t,h),x=(f*_-2*d*p+u*g)/(2*m),A=(_*g-p*p)/m,b=(x+Math.sqrt(Math.max(x*x-A,0))-1)/2;r[e[h]]=Math.max(r[e[h]],b)}for(let h=0;h<e.length;h++)o[h]=Math.max(0,r[e[h]]);return o}function l(){let c=new Float32Array(i.length),h=0;for(let u of n.time)h=a(n.verticesAt(u,c)).reduce((d,f)=>Math.max(d,f),h);return h}return{at:a,largest:l}}function lg(n,t,e){let[i,s,r]=[0,1,2].map(c=>3*t[3*e+c]),[o,a,l]=[0,0,0];for(let c=0;c<3;c++){let h=n[s+c]-n[i+c],u=n[r+c]-n[i+c];o+=h*h,a+=h*u,l+=u*u}return[o,a,l]}var Nw=.9,hg=.4,Dw=.02,Uw=["crease","rim","edge"],Zs=12;function vd(n,t){let{mesh:e}=n,i=new Float32Array(3*e.share.length),s=new Float32Array(n.tendons),r=Math.max(0,...e.tubes.map(P=>P.radius)),[o,a]=[!1,!0].map(P=>Fw(e,P)),l=ug(e.tubes.filter(P=>P.kind==="bar"),20,0),c=ug(e.tubes.filter(P=>Uw.includes(P.kind)),8,.4*r),h=kw(n,2.4*r),u=zw(e.base),d=n.efforts?Gm(n):null,f=n.strained?cg(n):null,m=0,_=Vw(e),p=new On;p.add(u.object,a.object,l.object,_.object,c.object,h.object,o.object),d&&p.add(d.group);let g=Ow(o.object,a.object,l.object),x=[0,0,0],A=new Qt;function b(P){n.verticesAt(P,i),o.pose(i),a.pose(i);for(let R of[l,c,_])R.pose(i);n.valuesAt(mr,P,s);let I=s.map(R=>t>0?R/t:0);h.pose(i,P,R=>hg+(1-hg)*Math.min(1,Math.max(0,I[R])/Dw));for(let R=0;R<n.tendons;R++)mo.at(I[R],x),h.colour(R,A.setRGB(...x,"srgb"));n.tendons&&(h.object.instanceColor.needsUpdate=!0),d?.pose(P),m&&C()}function C(){let P=f.at(i),I=[0,0,0];for(let R of[o,a])R.colour(F=>A.setRGB(...Zc.at(P[F]/m,I),"srgb"))}function M(P){m=f?P:0;for(let I of[o,a])I.flat(m>0),m||I.colour(R=>A.set(Ia(e.regions[R])));m&&C()}function y(){for(let P of[l,c,_,u])P.paint();d?.paint(),g.children[0].material.color.set(Fe("--shadow"))}function S(){for(let P of[l,c,h,_])P.object.dispose();for(let P of[o,a])P.dispose();d?.dispose(),u.dispose();for(let P of[l,c,h,_])P.object.geometry.dispose(),P.object.material.dispose();g.children[0].material.dispose()}return{group:p,shadow:g,pose:b,paint:y,sort:o.sort,vertices:i,tendons:h.object,efforts:d,strains:f,showStrain:M,dispose:S}}function Ow(...n){let t=new ar({side:Fn,transparent:!0,opacity:.12,depthWrite:!1,stencilWrite:!0,stencilRef:1,stencilFunc:Bu,stencilZPass:ku}),e=new On;for(let i of n){let s=i.isInstancedMesh?new li(i.geometry,t,i.count):new Ln(i.geometry,t);i.isInstancedMesh&&(s.instanceMatrix=i.instanceMatrix),s.frustumCulled=!1,e.add(s)}return e.scale.z=1e-5,e}function Fw(n,t){let e=n.regions.flatMap((b,C)=>n.solid[b]===t?[C]:[]),i=e.flatMap(b=>n.triangles.slice(3*b,3*b+3)),s=e.length,r=new nn(new Float32Array(3*i.length),3).setUsage(Ta),o=new nn(new Float32Array(3*i.length),3).setUsage(Ta),a=new nn(new Uint32Array(i.length),1).setUsage(Ta);for(let b=0;b<i.length;b++)a.array[b]=b;let l=new gn;l.setAttribute("position",r),l.setAttribute("color",o),l.setIndex(a);let c=new ps({vertexColors:!0,side:Fn,flatShading:!0,transparent:!t,opacity:t?1:Nw,depthWrite:t,forceSinglePass:!0});c.onBeforeCompile=b=>{b.fragmentShader=b.fragmentShader.replace("#include <color_fragment>",`#include <color_fragment>
if (!gl_FrontFacing) diffuseColor.rgb *= 0.84;`)};let h=new ar({vertexColors:!0,side:Fn}),u=new Ln(l,c);u.frustumCulled=!1,u.renderOrder=t?0:1;let d=new Qt;f(b=>d.set(Ia(n.regions[b])));function f(b){for(let[C,M]of e.entries()){let y=b(M);for(let S=0;S<3;S++)y.toArray(o.array,9*C+3*S)}o.needsUpdate=!0}let m=b=>{u.material=b?h:c};function _(){l.dispose(),c.dispose(),h.dispose()}function p(b){for(let C=0;C<i.length;C++)for(let M=0;M<3;M++)r.array[3*C+M]=b[3*i[C]+M];r.needsUpdate=!0}let g=new Float32Array(s),x=Array.from({length:s},(b,C)=>C);function A(b){let C=r.array;for(let M=0;M<s;M++){let y=0;for(let S=0;S<3;S++){let P=9*M+S;y+=((C[P]+C[P+3]+C[P+6])/3-b.getComponent(S))**2}g[M]=y}x.sort((M,y)=>g[y]-g[M]);for(let M=0;M<s;M++)for(let y=0;y<3;y++)a.array[3*M+y]=3*x[M]+y;a.needsUpdate=!0}return{object:u,pose:p,sort:A,colour:f,flat:m,dispose:_}}function ug(n,t,e){let i=new li(new Hi(1,1,1,t),pr(e),n.length);i.frustumCulled=!1,o();let s=n.map(a=>[3*a.ends[0],3*a.ends[1],a.radius]);function r(a,l=()=>1){let c=i.instanceMatrix.array;for(let[h,[u,d,f]]of s.entries())po(a,u,d,l(h)*f,c,16*h);i.instanceMatrix.needsUpdate=!0}function o(){let a={M:new Qt(qc),V:new Qt(Yc),B:new Qt(Fe("--bar"))};for(let[l,c]of n.entries())i.setColorAt(l,a[c.crease]);n.length&&(i.instanceColor.needsUpdate=!0)}return{object:i,pose:r,paint:o}}function kw(n,t){let e=n.mesh.tubes.filter(l=>l.kind==="tendon"),i=new li(new Hi(1,1,1,12),pr(t),e.length*Zs);i.frustumCulled=!1;let s=new Float32Array(e.length),r=new Float32Array(3*(Zs+1));function o(l,c,h){n.restLengthsAt(c,s);let u=i.instanceMatrix.array;for(let[d,{ends:f,radius:m}]of e.entries()){Bw(l,3*f[0],3*f[1],s[d],r);for(let _=0;_<Zs;_++)po(r,3*_,3*_+3,h(d)*m,u,16*(d*Zs+_))}i.instanceMatrix.needsUpdate=!0}function a(l,c){for(let h=0;h<Zs;h++)i.setColorAt(l*Zs+h,c)}return{object:i,pose:o,colour:a}}function Bw(n,t,e,i,s){let r=[0,1,2].map(d=>n[e+d]-n[t+d]),o=Math.hypot(...r),a=ag(o,i),l=Math.abs(r[2])>.999*o?[1,0,0]:[0,0,-1],c=l.reduce((d,f,m)=>d+f*r[m],0)/(o*o||1),h=l.map((d,f)=>d-c*r[f]),u=Math.hypot(...h)||1;for(let d=0;d<=Zs;d++){let f=d/Zs,m=4*a*f*(1-f)/u;for(let _=0;_<3;_++)s[3*d+_]=n[t+_]+f*r[_]+m*h[_]}}function zw({rods:n,radius:t}){let e=new Float32Array(n.flat(2)),i=pr(0),s=new li(new Hi(1,1,1,16),i,n.length),r=new li(new io(1,16,12),i,2*n.length),o=new On;for(let l of[s,r])l.frustumCulled=!1,o.add(l);for(let l=0;l<n.length;l++)po(e,6*l,6*l+3,t,s.instanceMatrix.array,16*l);for(let l=0;l<2*n.length;l++){let c=r.instanceMatrix.array;for(let h=0;h<3;h++)[c[16*l+5*h],c[16*l+12+h]]=[t,e[3*l+h]];c[16*l+15]=1}function a(){for(let l of[s,r])l.dispose(),l.geometry.dispose();i.dispose()}return{object:o,paint:()=>i.color.set(Fe("--base")),dispose:a}}function Vw(n){let t=new li(new io(1,16,12),pr(0),n.joints.length);t.frustumCulled=!1;let e=()=>t.material.color.set(Fe("--joint"));e();function i(s){let r=t.instanceMatrix.array;for(let[o,a]of n.joints.entries()){for(let l=0;l<3;l++)r[16*o+5*l]=n.jointRadius,r[16*o+12+l]=s[3*a+l];r[16*o+15]=1}t.instanceMatrix.needsUpdate=!0}return{object:t,pose:i,paint:e}}var Gw=4096,Hw=3.2,Ww=new X(-.45,.75,1),Xw=.42*Math.PI,$w=.64*Math.PI,qw=.5,Yw=.14;function Ua(n,t,e,i,s){let r=N("canvas",{tabIndex:0,role:"img","aria-label":`${i} ${Zw}`}),o=r.getContext("webgl2",{antialias:!0,alpha:!0,stencil:!0});if(!o)return null;let a=n.map(()=>N("div",{className:"cell"})),l=n.length>1,c=N("div",{className:l?"stage several":"stage"},r,...a);c.style.setProperty("--columns",String(n.length===4?2:Math.min(n.length,n.length>6?4:3)));let h=()=>l?Math.ceil(Hw*parseFloat(getComputedStyle(a[0]).fontSize)):0,u=new Wc({canvas:r,context:o,antialias:!0,alpha:!0,stencil:!0});u.setScissorTest(!0);let d=tg(r,n,t,p,s),f=n.map(I=>Kw(I,e(I),d)),m=0,_=!1;function p(){m||(m=requestAnimationFrame(x))}function g(){for(let[I,R]of f.entries())R.shape.pose(t.clipTime(I));_=!0}function x(){cancelAnimationFrame(m),m=0,_||g();let I=r.clientHeight,R=h();u.setScissor(0,0,r.clientWidth,I),u.setViewport(0,0,r.clientWidth,I),u.clear();for(let[F,z]of f.entries()){d.aim(F);let U=a[F],G=[U.offsetLeft,I-U.offsetTop-U.offsetHeight,U.offsetWidth,U.offsetHeight-R];u.setViewport(...G),u.setScissor(...G),z.light.position.copy(Ww).applyQuaternion(d.camera.quaternion);let q=d.camera.position.z>z.floor.position.z;z.floor.material.opacity=q?qw:Yw,z.shape.shadow.visible=q,z.shape.sort(d.camera.position),u.render(z.scene,d.camera)}d.aim()}function A(){for(let I of f)I.floor.material.color.set(Fe("--floor")),I.shape.paint();p()}function b(){let[I,R]=[c.clientWidth,c.clientHeight];if(!I||!R)return;u.setPixelRatio(Math.min(devicePixelRatio,2,Gw/Math.max(I,R))),u.setSize(I,R,!1);let F=a[0].offsetHeight-h();d.resize(a[0].offsetWidth/F,R/F),x()}let C=new ResizeObserver(b);C.observe(c);let M=t.onChange(()=>{_=!1,x()}),y=$s(A);r.addEventListener("webglcontextrestored",p),A();function S(){cancelAnimationFrame(m),M(),y(),C.disconnect(),d.dispose();for(let{shape:I,floor:R}of f)I.dispose(),R.geometry.dispose(),R.material.dispose();u.dispose(),u.forceContextLoss(),c.remove()}function P(I){let R=I?f.reduce((F,{shape:z})=>Math.max(F,z.strains?.largest()??0),0):0;for(let{shape:F}of f)F.showStrain(R||(I?Number.MIN_VALUE:0));return p(),R}return{element:c,canvas:r,cells:a,eye:d,pose:g,draw:x,views:f,showStrain:P,statistics:()=>u.info.render,dispose:S}}var Zw="Drag to turn it, pinch to zoom; keys are listed below.";function Kw(n,t,e){let i=rg(e.size,e.target);i.position.z=Jw(n)-.06*e.size,t.shadow.position.z=i.position.z+.001*e.size;let s=new ma("#ffffff",Xw),r=new ta;return r.add(t.group,t.shadow,i,s,new da("#ffffff","#dde2e8",$w)),{shape:t,floor:i,light:s,scene:r}}function Jw(n){let t=1/0,e=Math.max(1,Math.floor(n.time.length/200));for(let i=0;i<n.time.length;i+=e){let s=n.pointsAt(n.time[i]);for(let r=2;r<s.length;r+=3)t=Math.min(t,s[r])}return t}var jw="M7 4.5v15l12-7.5z",Qw="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",bd=1e4;function th(n,t){let e=N("button",{type:"button",className:"play"}),i=N("input",{type:"range",min:0,max:bd,step:1,"aria-label":"time"}),s=N("div",{className:"bands","aria-hidden":"true"}),r=N("div",{className:"ticks","aria-hidden":"true"}),o=N("p",{className:"time"}),a=N("p",{className:"spoken",role:"status"}),l=n.length===1?n[0].marks.map(f=>t1(f,t)):[],c=N("div",{className:"transport"},N("div",{className:"line"},e,N("div",{className:"track"},s,i,r)),N("div",{className:"choices"},o,...l.length?[N("div",{className:"states"},...l)]:[],e1(t),...n1(t),a));e.addEventListener("click",()=>t.playing?t.pause():t.play()),i.addEventListener("input",()=>{t.pause(),t.seek(t.momentAt(i.value/bd))});let h=null,u=null,d=0;return t.onChange(()=>{let f=`${t.spans.indexOf(t.span)} ${t.stretched}`;f!==h&&i1(n,t,s,r),h=f,i.value=Math.round(bd*t.shareAt(t.time)),i.setAttribute("aria-valuetext",dg(n,t));let m=n.length===1?` · ${eh(n[0],t.clipTime(0))}`:t.span.label.replace("time",""),_=t.playing?`, ${s1(t.slowness)}`:"";o.textContent=`${Na(t.time,t.span)}${m}${_}`;for(let[p,g]of(n.length===1?n[0].marks:[]).entries())l[p].setAttribute("aria-pressed",String(Math.abs(g.time-t.clipTime(0))<1e-9));t.playing!==u&&(e.replaceChildren(Za(t.playing?Qw:jw)),e.setAttribute("aria-label",t.playing?"pause":"play"),u=t.playing),clearTimeout(d),t.playing||(d=setTimeout(()=>{a.textContent=dg(n,t)},600))}),c}function t1(n,t){let e=N("button",{type:"button",className:"state"},N("b",{},n.letter),` ${n.name}`);return e.addEventListener("click",()=>{t.pause(),t.seekClip(0,n.time)}),e}function e1(n){let t=Wm.map(({name:i,value:s})=>N("option",{value:String(s)},i)),e=N("select",{},...t);return e.addEventListener("change",()=>n.setSpeed(e.value==="even"?"even":Number(e.value))),N("label",{},"speed ",e)}function n1(n){if(n.spans.length<2)return[];let t=n.spans.map((i,s)=>N("option",{value:String(s)},i.name)),e=N("select",{},...t);return e.addEventListener("change",()=>n.setSpan(n.spans[Number(e.value)])),n.onChange(()=>{e.value=String(n.spans.indexOf(n.span))}),[N("label",{},"show ",e)]}function i1(n,t,e,i){let{span:s}=t,r=o=>Math.min(1,Math.max(0,t.shareAt(o)));e.replaceChildren(),i.replaceChildren();for(let[o,a]of n.entries()){let l=s.origins[o];for(let c of a.stages.filter(h=>h.driven&&n.length===1)){let[h,u]=[r(c.start-l),r(c.end-l)],d=N("span",{className:"band"});d.style.left=`${100*h}%`,d.style.width=`${100*(u-h)}%`,u>h&&e.append(d)}for(let c of a.marks){let h=c.time-l;if(h<s.start-1e-9||h>s.end+1e-9)continue;let u=N("span",{className:"tick"},n.length===1?c.letter:"");u.style.left=`${100*r(h)}%`,n.length>1&&u.style.setProperty("--tick",`var(--line-${o%7})`),i.append(u)}}}function s1(n){return n<1.05?"real time":`${n<10?qn(n,1):Math.round(n)} times slower`}function eh(n,t){let e=n.markAt(t);return e?`${e.letter} ${e.name}`:n.stageAt(t).name}function dg(n,t){let e=n.map((i,s)=>{let r=t.clipTime(s);return`${n.length>1?`${i.name}: `:""}${eh(i,r)}${r1(i,r)}`});return`${Na(t.time,t.span)}: ${e.join("; ")}`}function r1(n,t){let[e]=n.readings;if(!e)return"";let i=n.markAt(t)?.readings[e.name]?.mean??n.valuesAt(e.name,t),s=e.unit==="deg"?"degrees":e.unit,r=[Math.min(...i),Math.max(...i)].map(a=>qn(a,1)),o=i.length>1;return`, ${e.label}${o?"s":""} ${o?r.join(" to "):r[0]} ${s}`}function go(n,t,e,{energy:i,legend:s,text:r,whole:o},a){let l=Ua(t,e,f=>vd(f,i.largest_J),r,a),c=l?N("div",{className:"picture"},l.element,ih(l.eye,t.length>1||a?o:null)):N("p",{className:"note"},nh(o));l&&t.length===1&&o1(l.cells[0],t[0],e);let h=l?[xd(s,i,l.eye.size,t.length>1?o:null)]:[];l&&t.some(f=>f.strained)&&h.unshift(mg(l,h[0])),l&&t.length===1&&t[0].efforts?.drives.length&&a1(h.at(-1),t[0],e),l&&t.length>1&&t.some(f=>f.efforts?.drives.some(m=>m.arrow))&&h.at(-1).append(N("li",{className:"effort"},pg(),"torque or force of a drive, while it acts")),n.replaceChildren(c,th(t,e),...h,jc(t,l!==null,o)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the ${o} moving`);let u=Qc(n,t,e,l?.eye,gr[0]);function d(){e.pause(),u(),l?.dispose(),n.replaceChildren()}return{stage:l,dispose:d}}function fg(n,t,e,{energy:i,legend:s,text:r,whole:o}){let a=Ua(t,e,h=>vd(h,i.largest_J),r);if(!a)return n.replaceChildren(N("p",{className:"note"},nh(o))),{stage:a};let l=N("div",{className:"picture"},a.element,ih(a.eye,null)),c=[xd(s,i,a.eye.size,null)];return t.some(h=>h.strained)&&c.unshift(mg(a,c[0])),n.replaceChildren(l,...c),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the ${o} where the sliders are`),ig(n,a.eye,gr[0]),{stage:a}}function o1(n,t,e){let i=N("p",{className:"now","aria-hidden":"true"});n.append(i),e.onChange(()=>{i.textContent=eh(t,e.clipTime(0))})}function pg(){return N("span",{className:"swatch arrow","aria-hidden":"true"})}function a1(n,t,e){let i=t.efforts.drives.some(r=>r.arrow),s=N("span");n.append(N("li",{className:"effort"},...i?[pg()]:[],s)),e.onChange(()=>{s.textContent=Vm(t.efforts,e.clipTime(0),yn).join("; ")||"no drive acts now"})}function mg(n,t){let e=["panels","membrane strain"],i=N("li",{className:"energy",hidden:!0});t.append(i);let s=e.map((r,o)=>{let a=N("button",{type:"button","aria-pressed":String(!o)},r);return a.addEventListener("click",()=>{let l=n.showStrain(!!o);i.replaceChildren("membrane strain, Green’s: 0",yd(Zc),`${yn(100*l)} %`),i.hidden=!o;for(let c of t.querySelectorAll(".of-region"))c.hidden=!!o;for(let c of s)c.setAttribute("aria-pressed",String(c===a))}),a});return N("div",{className:"colours",role:"group","aria-label":"colour of the sheet"},"colour:",N("span",{},...s))}function nh(n){return`This browser has no WebGL, so the ${n} cannot be drawn in 3-D. The plots and all numbers are here.`}function ih(n,t){let e=(l,c,h)=>{let u=N("button",{type:"button",title:c,"aria-label":c},l);return u.addEventListener("click",h),u},i=gr.map(l=>e(l.name,`${l.name}: view ${l.text}`,()=>n.show(l))),s=[["←","turn left",[-1,0]],["→","turn right",[1,0]],["↑","turn up",[0,1]],["↓","turn down",[0,-1]]].map(([l,c,h])=>e(l,c,()=>n.turn(...h))),r=(l,c,h)=>{let u=e(l,c,()=>{n.choose({[h]:!n.look[h]}),u.setAttribute("aria-pressed",String(n.look[h]))});return u.setAttribute("aria-pressed",String(n.look[h])),u},o=[r("follow","follow: keep the picture filled as it moves","following"),...t?[r("one scale",`one scale: all ${t}s as large as they are by each other`,"oneScale")]:[]],a=[e("+","nearer",()=>n.zoom(1)),e("−","further",()=>n.zoom(-1))];return N("div",{className:"views",role:"group","aria-label":"view"},N("span",{},...o),N("span",{},...i),N("span",{className:"turns"},...s),N("span",{},...a))}var l1="uplot",c1="u-hz",h1="u-vt",u1="u-title",d1="u-wrap",f1="u-under",p1="u-over",m1="u-axis",yr="u-off",g1="u-select",_1="u-cursor-x",x1="u-cursor-y",y1="u-cursor-pt",v1="u-legend",b1="u-live",S1="u-inline",M1="u-series",w1="u-marker",gg="u-label",A1="u-value",Fa="width",ka="height";var _g="bottom",_o="left",Sd="right",Bd="#000",xg=Bd+"0",Md="mousemove",yg="mousedown",wd="mouseup",vg="mouseenter",bg="mouseleave",Sg="dblclick",T1="resize",E1="scroll",Mg="change",lh="dppxchange",zd="--",wo=typeof window<"u",Rd=wo?document:null,yo=wo?window:null,C1=wo?navigator:null,we,sh;function Pd(){let n=devicePixelRatio;we!=n&&(we=n,sh&&Ld(Mg,sh,Pd),sh=matchMedia(`(min-resolution: ${we-.001}dppx) and (max-resolution: ${we+.001}dppx)`),vr(Mg,sh,Pd),yo.dispatchEvent(new CustomEvent(lh)))}function hi(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Id(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function He(n,t,e){n.style[t]=e+"px"}function Pi(n,t,e,i){let s=Rd.createElement(n);return t!=null&&hi(s,t),e?.insertBefore(s,i),s}function xi(n,t){return Pi("div",n,t)}var wg=new WeakMap;function Ki(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=wg.get(n);r!=o&&(n.style.transform=r,wg.set(n,r),t<0||e<0||t>i||e>s?hi(n,yr):Id(n,yr))}var Ag=new WeakMap;function Tg(n,t,e){let i=t+e,s=Ag.get(n);i!=s&&(Ag.set(n,i),n.style.background=t,n.style.borderColor=e)}var Eg=new WeakMap;function Cg(n,t,e,i){let s=t+""+e,r=Eg.get(n);s!=r&&(Eg.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Vd={passive:!0},R1={...Vd,capture:!0};function vr(n,t,e,i){t.addEventListener(n,e,i?R1:Vd)}function Ld(n,t,e,i){t.removeEventListener(n,e,Vd)}wo&&Pd();function Ii(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:ui((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function n0(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var i0=n=>n!=null,s0=n=>n!=null&&n>0,uh=n0(i0),P1=n0(s0);function I1(n,t,e,i=0,s=!1){let r=s?P1:uh,o=s?s0:i0;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let h=n[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??De,l??-De]}function dh(n,t,e,i){let s=Ig(n),r=Ig(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?vs:r0,a=s==1?ui:yi,l=r==1?yi:ui,c=a(o(Sn(n))),h=l(o(Sn(t))),u=vo(e,c),d=vo(e,h);return e==10&&(c<0&&(u=Ue(u,-c)),h<0&&(d=Ue(d,-h))),i||e==2?(n=u*s,t=d*r):(n=c0(n,u),t=fh(t,d)),[n,t]}function Gd(n,t,e,i){let s=dh(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var Hd=.1,Rg={mode:3,pad:Hd},za={pad:0,soft:null,mode:0},L1={min:za,max:za};function ch(n,t,e,i){return ph(e)?Pg(n,t,e):(za.pad=e,za.soft=i?0:null,za.mode=i?3:0,Pg(n,t,L1))}function be(n,t){return n??t}function N1(n,t,e){for(t=be(t,0),e=be(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function Pg(n,t,e){let i=e.min,s=e.max,r=be(i.pad,0),o=be(s.pad,0),a=be(i.hard,-De),l=be(s.hard,De),c=be(i.soft,De),h=be(s.soft,-De),u=be(i.mode,0),d=be(s.mode,0),f=t-n,m=vs(f),_=Yn(Sn(n),Sn(t)),p=vs(_),g=Sn(p-m);(f<1e-24||g>10)&&(f=0,(n==0||t==0)&&(f=1e-24,u==2&&c!=De&&(r=0),d==2&&h!=-De&&(o=0)));let x=f||_||1e3,A=vs(x),b=vo(10,ui(A)),C=x*(f==0?n==0?.1:1:r),M=Ue(c0(n-C,b/10),24),y=n>=c&&(u==1||u==3&&M<=c||u==2&&M>=c)?c:De,S=Yn(a,M<y&&n>=y?y:Li(y,M)),P=x*(f==0?t==0?.1:1:o),I=Ue(fh(t+P,b/10),24),R=t<=h&&(d==1||d==3&&I>=h||d==2&&I<=h)?h:-De,F=Li(l,I>R&&t<=R?R:Yn(R,I));return S==F&&S==0&&(F=100),[S,F]}var D1=new Intl.NumberFormat(wo?C1.language:"en-US"),Wd=n=>D1.format(n),di=Math,ah=di.PI,Sn=di.abs,ui=di.floor,bn=di.round,yi=di.ceil,Li=di.min,Yn=di.max,vo=di.pow,Ig=di.sign,vs=di.log10,r0=di.log2,U1=(n,t=1)=>di.sinh(n)*t,Ad=(n,t=1)=>di.asinh(n/t),De=1/0;function Lg(n){return(vs((n^n>>31)-(n>>31))|0)+1}function Nd(n,t,e){return Li(Yn(n,t),e)}function o0(n){return typeof n=="function"}function xe(n){return o0(n)?n:()=>n}var O1=()=>{},a0=n=>n,l0=(n,t)=>t,F1=n=>null,Ng=n=>!0,Dg=(n,t)=>n==t,k1=/\.\d*?(?=9{6,}|0{6,})/gm,br=n=>{if(u0(n)||Js.has(n))return n;let t=`${n}`,e=t.match(k1);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${br(s)}e${r}`}return Ue(n,i)};function _r(n,t){return br(Ue(br(n/t))*t)}function fh(n,t){return br(yi(br(n/t))*t)}function c0(n,t){return br(ui(br(n/t))*t)}function Ue(n,t=0){if(u0(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return bn(i)/e}var Js=new Map;function h0(n){return((""+n).split(".")[1]||"").length}function Ga(n,t,e,i){let s=[],r=i.map(h0);for(let o=t;o<e;o++){let a=Sn(o),l=Ue(vo(n,o),a);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${o}`:i[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?h:Ue(h,u);s.push(d),Js.set(d,u)}}return s}var Va={},Xd=[],bo=[null,null],Ks=Array.isArray,u0=Number.isInteger,B1=n=>n===void 0;function Ug(n){return typeof n=="string"}function ph(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function z1(n){return n!=null&&typeof n=="object"}var V1=Object.getPrototypeOf(Uint8Array),d0="__proto__";function So(n,t=ph){let e;if(Ks(n)){let i=n.find(s=>s!=null);if(Ks(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=So(n[s],t)}else e=n.slice()}else if(n instanceof V1)e=n.slice();else if(t(n)){e={};for(let i in n)i!=d0&&(e[i]=So(n[i],t))}else e=n;return e}function fn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=d0&&(ph(n[s])?fn(n[s],So(i[s])):n[s]=So(i[s]))}return n}var G1=0,H1=1,W1=2;function X1(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function $1(n,t){if(Z1(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return K1(o[0])||(o=Y1(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=t?t[o][c]:H1,f=[];for(let m=0;m<h.length;m++){let _=h[m],p=r.get(l[m]);_===null?d!=G1&&(u[p]=_,d==W1&&f.push(p)):u[p]=_}X1(u,f,s),i.push(u)}}return i}var q1=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Y1(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function Z1(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function K1(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Yn(1,ui((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var f0=["January","February","March","April","May","June","July","August","September","October","November","December"],p0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function m0(n){return n.slice(0,3)}var J1=p0.map(m0),j1=f0.map(m0),Q1={MMMM:f0,MMM:j1,WWWW:p0,WWW:J1};function Oa(n){return(n<10?"0":"")+n}function tA(n){return(n<10?"00":n<100?"0":"")+n}var eA={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Oa(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Oa(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Oa(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Oa(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Oa(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>tA(n.getMilliseconds())};function $d(n,t){t=t||Q1;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?eA[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var nA=new Intl.DateTimeFormat().resolvedOptions().timeZone;function iA(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==nA?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var g0=n=>n%1==0,hh=[1,2,2.5,5],sA=Ga(10,-32,0,hh),_0=Ga(10,0,32,hh),rA=_0.filter(g0),xr=sA.concat(_0),qd=`
`,x0="{YYYY}",Og=qd+x0,y0="{M}/{D}",Ba=qd+y0,rh=Ba+"/{YY}",v0="{aa}",oA="{h}:{mm}",xo=oA+v0,Fg=qd+xo,kg=":{ss}",Te=null;function b0(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Ga(10,0,3,hh).filter(g0):Ga(10,-3,0,hh)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,x0,Te,Te,Te,Te,Te,Te,1],[s*28,"{MMM}",Og,Te,Te,Te,Te,Te,1],[s,y0,Og,Te,Te,Te,Te,Te,1],[i,"{h}"+v0,rh,Te,Ba,Te,Te,Te,1],[e,xo,rh,Te,Ba,Te,Te,Te,1],[t,kg,rh+" "+xo,Te,Ba+" "+xo,Te,Fg,Te,1],[n,kg+".{fff}",rh+" "+xo,Te,Ba+" "+xo,Te,Fg,Te,1]];function h(u){return(d,f,m,_,p,g)=>{let x=[],A=p>=o,b=p>=r&&p<o,C=u(m),M=Ue(C*n,3),y=Td(C.getFullYear(),A?0:C.getMonth(),b||A?1:C.getDate()),S=Ue(y*n,3);if(b||A){let P=b?p/r:0,I=A?p/o:0,R=M==S?M:Ue(Td(y.getFullYear()+I,y.getMonth()+P,1)*n,3),F=new Date(bn(R/n)),z=F.getFullYear(),U=F.getMonth();for(let G=0;R<=_;G++){let q=Td(z+I*G,U+P*G,1),H=q-u(Ue(q*n,3));R=Ue((+q+H)*n,3),R<=_&&x.push(R)}}else{let P=p>=s?s:p,I=ui(m)-ui(M),R=S+I+fh(M-S,P);x.push(R);let F=u(R),z=F.getHours()+F.getMinutes()/e+F.getSeconds()/i,U=p/i,G=d.axes[f]._space,q=g/G;for(;R=Ue(R+p,n==1?0:3),!(R>_);)if(U>1){let H=ui(Ue(z+U,6))%24,Q=u(R).getHours()-H;Q>1&&(Q=-1),R-=Q*i,z=(z+U)%24;let it=x[x.length-1];Ue((R-it)/p,3)*q>=.7&&x.push(R)}else x.push(R)}return x}}return[l,c,h]}var[aA,lA,cA]=b0(1),[hA,uA,dA]=b0(.001);Ga(2,-53,53,[1]);function Bg(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function zg(n,t){return(e,i,s,r,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,h,u,d,f;return i.map(m=>{let _=n(m),p=_.getFullYear(),g=_.getMonth(),x=_.getDate(),A=_.getHours(),b=_.getMinutes(),C=_.getSeconds(),M=p!=l&&a[2]||g!=c&&a[3]||x!=h&&a[4]||A!=u&&a[5]||b!=d&&a[6]||C!=f&&a[7]||a[1];return l=p,c=g,h=x,u=A,d=b,f=C,M(_)})}}function fA(n,t){let e=$d(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Td(n,t,e){return new Date(n,t,e)}function Vg(n,t){return t(n)}var pA="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Gg(n,t){return(e,i,s,r)=>r==null?zd:t(n(i))}function mA(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function gA(n,t){return n.series[t].fill(n,t)}var _A={show:!0,live:!0,isolate:!1,mount:O1,markers:{show:!0,width:2,stroke:mA,fill:gA,dash:"solid"},idx:null,idxs:null,values:[]};function xA(n,t){let e=n.cursor.points,i=xi(),s=e.size(n,t);He(i,Fa,s),He(i,ka,s);let r=s/-2;He(i,"marginLeft",r),He(i,"marginTop",r);let o=e.width(n,t,s);return o&&He(i,"borderWidth",o),i}function yA(n,t){let e=n.series[t].points;return e._fill||e._stroke}function vA(n,t){let e=n.series[t].points;return e._stroke||e._fill}function bA(n,t){return n.series[t].points.size}var Ed=[0,0];function SA(n,t,e){return Ed[0]=t,Ed[1]=e,Ed}function oh(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Cd(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var MA={show:!0,x:!0,y:!0,lock:!1,move:SA,points:{one:!1,show:xA,size:bA,width:0,stroke:vA,fill:yA},bind:{mousedown:oh,mouseup:oh,click:oh,dblclick:oh,mousemove:Cd,mouseleave:Cd,mouseenter:Cd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},S0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Yd=fn({},S0,{filter:l0}),M0=fn({},Yd,{size:10}),w0=fn({},S0,{show:!1}),Zd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',A0="bold "+Zd,T0=1.5,Hg={show:!0,scale:"x",stroke:Bd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:A0,side:2,grid:Yd,ticks:M0,border:w0,font:Zd,lineGap:T0,rotate:0},wA="Value",AA="Time",Wg={show:!0,scale:"x",auto:!1,sorted:1,min:De,max:-De,idxs:[]};function TA(n,t,e,i,s){return t.map(r=>r==null?"":Wd(r))}function EA(n,t,e,i,s,r,o){let a=[],l=Js.get(s)||0;e=o?e:Ue(fh(e,s),l);for(let c=e;c<=i;c=Ue(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Dd(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?vs:r0,h=ui(c(e));s=vo(l,h),l==10&&(s=xr[Ii(s,xr)]);let u=e,d=s*l;l==10&&(d=xr[Ii(d,xr)]);do a.push(u),u=u+s,l==10&&!Js.has(u)&&(u=Ue(u,Js.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=xr[Ii(d,xr)]));while(u<=i);return a}function CA(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Dd(n,t,Yn(l,e),i,s):[l],h=i>=0&&e<=0?[0]:[];return(e<-l?Dd(n,t,Yn(l,-i),-e,s):[l]).reverse().map(d=>-d).concat(h,c)}var E0=/./,RA=/[12357]/,PA=/[125]/,Xg=/1/,Ud=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function IA(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?E0:l(7,o)-h>=c?RA:l(5,o)-h>=c?PA:Xg;if(u==Xg){let d=Sn(l(1,o)-h);if(d<c)return Ud(t.slice().reverse(),a.distr,u,yi(c/d)).reverse()}return Ud(t,a.distr,u,1)}function LA(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=Sn(l(1,o)-l(2,o));return c<a?Ud(t.slice().reverse(),3,E0,yi(a/c)).reverse():t}function NA(n,t,e,i){return i==null?zd:t==null?"":Wd(t)}var $g={show:!0,scale:"y",stroke:Bd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:A0,side:3,grid:Yd,ticks:M0,border:w0,font:Zd,lineGap:T0,rotate:0};function DA(n,t){let e=3+(n||1)*2;return Ue(e*t,3)}function UA(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=Sn(o-r),l=n.series[t],c=a/(l.points.space*we);return i[1]-i[0]<=c}var qg={scale:null,auto:!0,sorted:0,min:De,max:-De},C0=(n,t,e,i,s)=>s,Yg={show:!0,auto:!0,sorted:0,gaps:C0,alpha:1,facets:[fn({},qg,{scale:"x"}),fn({},qg,{scale:"y"})]},Zg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:C0,alpha:1,points:{show:UA,filter:null},values:null,min:De,max:-De,idxs:[],path:null,clip:null};function OA(n,t,e,i,s){return e/10}var R0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},FA=fn({},R0,{time:!1,ori:1}),Kg={};function P0(n,t){let e=Kg[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(i,s,r,o,a,l,c)}},n!=null&&(Kg[n]=e)),e}var Mo=1,Od=2;function Sr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],h=i==2?o[s.facets[0].scale]:o[n.series[0].scale],u=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,m=a.width,_=a.height,p=n.valToPosH,g=n.valToPosV;return h.ori==0?e(s,l,c,h,u,p,g,d,f,m,_,gh,Ao,xh,L0,D0):e(s,l,c,h,u,g,p,f,d,_,m,_h,To,jd,N0,U0)}function Kd(n,t){let e=0,i=0,s=be(n.bands,Xd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function kA(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function bs(n,t,e,i,s,r){return Sr(n,t,(o,a,l,c,h,u,d,f,m,_,p)=>{let g=o.pxRound,x=c.dir*(c.ori==0?1:-1),A=c.ori==0?Ao:To,b,C;x==1?(b=e,C=i):(b=i,C=e);let M=g(u(a[b],c,_,f)),y=g(d(l[b],h,p,m)),S=g(u(a[C],c,_,f)),P=g(d(r==1?h.max:h.min,h,p,m)),I=new Path2D(s);return A(I,S,P),A(I,M,P),A(I,M,y),I})}function mh(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?xh:jd,l=e;for(let u=0;u<n.length;u++){let d=n[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=e+s-l,h=10;c>0&&a(o,l,i-h/2,c,i+r+h)}return o}function BA(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function Jd(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let u=c,d=c;if(s==1)for(;++c<=i&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(n[u]),m=d==u?f:r(n[d]),_=u-s;f=o<=0&&_>=0&&_<l?r(n[_]):f;let g=d+s;m=o>=0&&g>=0&&g<l?r(n[g]):m,m>=f&&a.push([f,m])}return a}function Jg(n){return n==0?a0:n==1?bn:t=>_r(t,n)}function I0(n){let t=n==0?gh:_h,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?i(s,r,o,a,l):(c=Li(c,a/2,l/2),h=Li(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var gh=(n,t,e)=>{n.moveTo(t,e)},_h=(n,t,e)=>{n.moveTo(e,t)},Ao=(n,t,e)=>{n.lineTo(t,e)},To=(n,t,e)=>{n.lineTo(e,t)},xh=I0(0),jd=I0(1),L0=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},N0=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},D0=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},U0=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function O0(n){return(t,e,i,s,r)=>Sr(t,e,(o,a,l,c,h,u,d,f,m,_,p)=>{let{pxRound:g,points:x}=o,A,b;c.ori==0?(A=gh,b=L0):(A=_h,b=N0);let C=Ue(x.width*we,3),M=(x.size-x.width)/2*we,y=Ue(M*2,3),S=new Path2D,P=new Path2D,{left:I,top:R,width:F,height:z}=t.bbox;xh(P,I-y,R-y,F+y*2,z+y*2);let U=G=>{if(l[G]!=null){let q=g(u(a[G],c,_,f)),H=g(d(l[G],h,p,m));A(S,q+M,H),b(S,q,H,M,0,ah*2)}};if(r)r.forEach(U);else for(let G=i;G<=s;G++)U(G);return{stroke:C>0?S:null,fill:S,clip:P,flags:Mo|Od}})}function F0(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var zA=F0(Ao),VA=F0(To);function k0(n){let t=be(n?.alignGaps,0);return(e,i,s,r)=>Sr(e,i,(o,a,l,c,h,u,d,f,m,_,p)=>{[s,r]=uh(l,s,r);let g=o.pxRound,x=z=>g(u(z,c,_,f)),A=z=>g(d(z,h,p,m)),b,C;c.ori==0?(b=Ao,C=zA):(b=To,C=VA);let M=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Mo},S=y.stroke,P=!1;if(r-s>=_*4){let z=dt=>e.posToVal(dt,c.key,!0),U=null,G=null,q,H,lt,K=x(a[M==1?s:r]),Q=x(a[s]),it=x(a[r]),ft=z(M==1?Q+1:it-1);for(let dt=M==1?s:r;dt>=s&&dt<=r;dt+=M){let tt=a[dt],gt=(M==1?tt<ft:tt>ft)?K:x(tt),St=l[dt];gt==K?St!=null?(H=St,U==null?(b(S,gt,A(H)),q=U=G=H):H<U?U=H:H>G&&(G=H)):St===null&&(P=!0):(U!=null&&C(S,K,A(U),A(G),A(q),A(H)),St!=null?(H=St,b(S,gt,A(H)),U=G=q=H):(U=G=null,St===null&&(P=!0)),K=gt,ft=z(K+M))}U!=null&&U!=G&&lt!=K&&C(S,K,A(U),A(G),A(q),A(H))}else for(let z=M==1?s:r;z>=s&&z<=r;z+=M){let U=l[z];U===null?P=!0:U!=null&&b(S,x(a[z]),A(U))}let[R,F]=Kd(e,i);if(o.fill!=null||R!=0){let z=y.fill=new Path2D(S),U=o.fillTo(e,i,o.min,o.max,R),G=A(U),q=x(a[s]),H=x(a[r]);M==-1&&([H,q]=[q,H]),b(z,H,G),b(z,q,G)}if(!o.spanGaps){let z=[];P&&z.push(...Jd(a,l,s,r,M,x,t)),y.gaps=z=o.gaps(e,i,s,r,z),y.clip=mh(z,c.ori,f,m,_,p)}return F!=0&&(y.band=F==2?[bs(e,i,s,r,S,-1),bs(e,i,s,r,S,1)]:bs(e,i,s,r,S,F)),y})}function GA(n){let t=be(n.align,1),e=be(n.ascDesc,!1),i=be(n.alignGaps,0),s=be(n.extend,!1);return(r,o,a,l)=>Sr(r,o,(c,h,u,d,f,m,_,p,g,x,A)=>{[a,l]=uh(u,a,l);let b=c.pxRound,{left:C,width:M}=r.bbox,y=Q=>b(m(Q,d,x,p)),S=Q=>b(_(Q,f,A,g)),P=d.ori==0?Ao:To,I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Mo},R=I.stroke,F=d.dir*(d.ori==0?1:-1),z=S(u[F==1?a:l]),U=y(h[F==1?a:l]),G=U,q=U;s&&t==-1&&(q=C,P(R,q,z)),P(R,U,z);for(let Q=F==1?a:l;Q>=a&&Q<=l;Q+=F){let it=u[Q];if(it==null)continue;let ft=y(h[Q]),dt=S(it);t==1?P(R,ft,z):P(R,G,dt),P(R,ft,dt),z=dt,G=ft}let H=G;s&&t==1&&(H=C+M,P(R,H,z));let[lt,K]=Kd(r,o);if(c.fill!=null||lt!=0){let Q=I.fill=new Path2D(R),it=c.fillTo(r,o,c.min,c.max,lt),ft=S(it);P(Q,H,ft),P(Q,q,ft)}if(!c.spanGaps){let Q=[];Q.push(...Jd(h,u,a,l,F,y,i));let it=c.width*we/2,ft=e||t==1?it:-it,dt=e||t==-1?-it:it;Q.forEach(tt=>{tt[0]+=ft,tt[1]+=dt}),I.gaps=Q=c.gaps(r,o,a,l,Q),I.clip=mh(Q,d.ori,p,g,x,A)}return K!=0&&(I.band=K==2?[bs(r,o,a,l,R,-1),bs(r,o,a,l,R,1)]:bs(r,o,a,l,R,K)),I})}function jg(n,t,e,i,s,r,o=De){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let h=Sn(n[l]-n[a]);h<c&&(c=h,o=Sn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function HA(n){n=n||Va;let t=be(n.size,[.6,De,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=xe(s),o=1-t[0],a=be(t[1],De),l=be(t[2],1),c=be(n.disp,Va),h=be(n.each,f=>{}),{fill:u,stroke:d}=c;return(f,m,_,p)=>Sr(f,m,(g,x,A,b,C,M,y,S,P,I,R)=>{let F=g.pxRound,z=e,U=i*we,G=a*we,q=l*we,H,lt;b.ori==0?[H,lt]=r(f,m):[lt,H]=r(f,m);let K=b.dir*(b.ori==0?1:-1),Q=b.ori==0?xh:jd,it=b.ori==0?h:(Rt,qt,re,wt,Ne,zt,Xt)=>{h(Rt,qt,re,Ne,wt,Xt,zt)},ft=be(f.bands,Xd).find(Rt=>Rt.series[0]==m),dt=ft!=null?ft.dir:0,tt=g.fillTo(f,m,g.min,g.max,dt),ut=F(y(tt,C,R,P)),gt,St,Mt,Ht=I,se=F(g.width*we),Vt=!1,he=null,ae=null,ne=null,We=null;u!=null&&(se==0||d!=null)&&(Vt=!0,he=u.values(f,m,_,p),ae=new Map,new Set(he).forEach(Rt=>{Rt!=null&&ae.set(Rt,new Path2D)}),se>0&&(ne=d.values(f,m,_,p),We=new Map,new Set(ne).forEach(Rt=>{Rt!=null&&We.set(Rt,new Path2D)})));let{x0:Oe,size:rn}=c;if(Oe!=null&&rn!=null){z=1,x=Oe.values(f,m,_,p),Oe.unit==2&&(x=x.map(re=>f.posToVal(S+re*I,b.key,!0)));let Rt=rn.values(f,m,_,p);rn.unit==2?St=Rt[0]*I:St=M(Rt[0],b,I,S)-M(0,b,I,S),Ht=jg(x,A,M,b,I,S,Ht),Mt=Ht-St+U}else Ht=jg(x,A,M,b,I,S,Ht),Mt=Ht*o+U,St=Ht-Mt;Mt<1&&(Mt=0),se>=St/2&&(se=0),Mt<5&&(F=a0);let Ie=Mt>0,Mn=Ht-Mt-(Ie?se:0);St=F(Nd(Mn,q,G)),gt=(z==0?St/2:z==K?0:St)-z*K*((z==0?U/2:0)+(Ie?se/2:0));let ye={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},pn=Vt?null:new Path2D,Ye=null;if(ft!=null)Ye=f.data[ft.series[1]];else{let{y0:Rt,y1:qt}=c;Rt!=null&&qt!=null&&(A=qt.values(f,m,_,p),Ye=Rt.values(f,m,_,p))}let on=H*St,B=lt*St;for(let Rt=K==1?_:p;Rt>=_&&Rt<=p;Rt+=K){let qt=A[Rt];if(qt==null)continue;if(Ye!=null){let $=Ye[Rt]??0;if(qt-$==0)continue;ut=y($,C,R,P)}let re=b.distr!=2||c!=null?x[Rt]:Rt,wt=M(re,b,I,S),Ne=y(be(qt,tt),C,R,P),zt=F(wt-gt),Xt=F(Yn(Ne,ut)),L=F(Li(Ne,ut)),w=Xt-L;if(qt!=null){let $=qt<0?B:on,ht=qt<0?on:B;Vt?(se>0&&ne[Rt]!=null&&Q(We.get(ne[Rt]),zt,L+ui(se/2),St,Yn(0,w-se),$,ht),he[Rt]!=null&&Q(ae.get(he[Rt]),zt,L+ui(se/2),St,Yn(0,w-se),$,ht)):Q(pn,zt,L+ui(se/2),St,Yn(0,w-se),$,ht),it(f,m,Rt,zt-se/2,L,St+se,w)}}return se>0?ye.stroke=Vt?We:pn:Vt||(ye._fill=g.width==0?g._fill:g._stroke??g._fill,ye.width=0),ye.fill=Vt?ae:pn,ye})}function WA(n,t){let e=be(t?.alignGaps,0);return(i,s,r,o)=>Sr(i,s,(a,l,c,h,u,d,f,m,_,p,g)=>{[r,o]=uh(c,r,o);let x=a.pxRound,A=H=>x(d(H,h,p,m)),b=H=>x(f(H,u,g,_)),C,M,y;h.ori==0?(C=gh,y=Ao,M=D0):(C=_h,y=To,M=U0);let S=h.dir*(h.ori==0?1:-1),P=A(l[S==1?r:o]),I=P,R=[],F=[];for(let H=S==1?r:o;H>=r&&H<=o;H+=S)if(c[H]!=null){let K=l[H],Q=A(K);R.push(I=Q),F.push(b(c[H]))}let z={stroke:n(R,F,C,y,M,x),fill:null,clip:null,band:null,gaps:null,flags:Mo},U=z.stroke,[G,q]=Kd(i,s);if(a.fill!=null||G!=0){let H=z.fill=new Path2D(U),lt=a.fillTo(i,s,a.min,a.max,G),K=b(lt);y(H,I,K),y(H,P,K)}if(!a.spanGaps){let H=[];H.push(...Jd(l,c,r,o,S,A,e)),z.gaps=H=a.gaps(i,s,r,o,H),z.clip=mh(H,h.ori,m,_,p,g)}return q!=0&&(z.band=q==2?[bs(i,s,r,o,U,-1),bs(i,s,r,o,U,1)]:bs(i,s,r,o,U,q)),z})}function XA(n){return WA($A,n)}function $A(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=t[d+1]-t[d],u[d]=n[d+1]-n[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+u[d]/3,t[d]+l[d]*u[d]/3,n[d+1]-u[d]/3,t[d+1]-l[d+1]*u[d]/3,n[d+1],t[d+1])}return a}var Fd=new Set;function Qg(){for(let n of Fd)n.syncRect(!0)}wo&&(vr(T1,yo,Qg),vr(E1,yo,Qg,!0),vr(lh,yo,()=>{sn.pxRatio=we}));var qA=k0(),YA=O0();function t0(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>kd(r,o,t,e))}function ZA(n,t){return n.map((e,i)=>i==0?{}:fn({},t,e))}function kd(n,t,e,i){return fn({},t==0?e:i,n)}function B0(n,t,e){return t==null?bo:[t,e]}var KA=B0;function JA(n,t,e){return t==null?bo:ch(t,e,Hd,!0)}function z0(n,t,e,i){return t==null?bo:dh(t,e,n.scales[i].log,!1)}var jA=z0;function V0(n,t,e,i){return t==null?bo:Gd(t,e,n.scales[i].log,!1)}var QA=V0;function tT(n,t,e,i,s){let r=Yn(Lg(n),Lg(t)),o=t-n,a=Ii(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?Js.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function e0(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=bn((e=+s)*we))+"px"),[n,t,e]}function eT(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Ue(t[2]*we,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function sn(n,t,e){let i={mode:be(n.mode,1)},s=i.mode;function r(v,T,D,O){let W=T.valToPct(v);return O+D*(T.dir==-1?1-W:W)}function o(v,T,D,O){let W=T.valToPct(v);return O+D*(T.dir==-1?W:1-W)}function a(v,T,D,O){return T.ori==0?r(v,T,D,O):o(v,T,D,O)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=xi(l1);if(n.id!=null&&(c.id=n.id),hi(c,n.class),n.title){let v=xi(u1,c);v.textContent=n.title}let h=Pi("canvas"),u=i.ctx=h.getContext("2d"),d=xi(d1,c);vr("click",d,v=>{v.target===m&&(Be!=Rr||Xe!=Pr)&&Pn.click(i,v)},!0);let f=i.under=xi(f1,d);d.appendChild(h);let m=i.over=xi(p1,d);n=So(n);let _=+be(n.pxAlign,1),p=Jg(_);(n.plugins||[]).forEach(v=>{v.opts&&(n=v.opts(i,n)||n)});let g=n.ms||.001,x=i.series=s==1?t0(n.series||[],Wg,Zg,!1):ZA(n.series||[null],Yg),A=i.axes=t0(n.axes||[],Hg,$g,!0),b=i.scales={},C=i.bands=n.bands||[];C.forEach(v=>{v.fill=xe(v.fill||null),v.dir=be(v.dir,-1)});let M=s==2?x[1].facets[0].scale:x[0].scale,y={axes:es,series:de},S=(n.drawOrder||["axes","series"]).map(v=>y[v]);function P(v){let T=v.distr==3?D=>vs(D>0?D:v.clamp(i,D,v.min,v.max,v.key)):v.distr==4?D=>Ad(D,v.asinh):v.distr==100?D=>v.fwd(D):D=>D;return D=>{let O=T(D),{_min:W,_max:J}=v,at=J-W;return(O-W)/at}}function I(v){let T=b[v];if(T==null){let D=(n.scales||Va)[v]||Va;if(D.from!=null){I(D.from);let O=fn({},b[D.from],D,{key:v});O.valToPct=P(O),b[v]=O}else{T=b[v]=fn({},v==M?R0:FA,D),T.key=v;let O=T.time,W=T.range,J=Ks(W);if((v!=M||s==2&&!O)&&(J&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Rg:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Rg:{mode:1,hard:W[1],soft:W[1]}},J=!1),!J&&ph(W))){let at=W;W=(pt,vt,Nt)=>vt==null?bo:ch(vt,Nt,at)}T.range=xe(W||(O?KA:v==M?T.distr==3?jA:T.distr==4?QA:B0:T.distr==3?z0:T.distr==4?V0:JA)),T.auto=xe(J?!1:T.auto),T.clamp=xe(T.clamp||OA),T._min=T._max=null,T.valToPct=P(T)}}}I("x"),I("y"),s==1&&x.forEach(v=>{I(v.scale)}),A.forEach(v=>{I(v.scale)});for(let v in n.scales)I(v);let R=b[M],F=R.distr,z,U;R.ori==0?(hi(c,c1),z=r,U=o):(hi(c,h1),z=o,U=r);let G={};for(let v in b){let T=b[v];(T.min!=null||T.max!=null)&&(G[v]={min:T.min,max:T.max},T.min=T.max=null)}let q=n.tzDate||(v=>new Date(bn(v/g))),H=n.fmtDate||$d,lt=g==1?cA(q):dA(q),K=zg(q,Bg(g==1?lA:uA,H)),Q=Gg(q,Vg(pA,H)),it=[],ft=i.legend=fn({},_A,n.legend),dt=i.cursor=fn({},MA,{drag:{y:s==2}},n.cursor),tt=ft.show,ut=dt.show,gt=ft.markers;ft.idxs=it,gt.width=xe(gt.width),gt.dash=xe(gt.dash),gt.stroke=xe(gt.stroke),gt.fill=xe(gt.fill);let St,Mt,Ht,se=[],Vt=[],he,ae=!1,ne={};if(ft.live){let v=x[1]?x[1].values:null;ae=v!=null,he=ae?v(i,1,0):{_:0};for(let T in he)ne[T]=zd}if(tt)if(St=Pi("table",v1,c),Ht=Pi("tbody",null,St),ft.mount(i,St),ae){Mt=Pi("thead",null,St,Ht);let v=Pi("tr",null,Mt);Pi("th",null,v);for(var We in he)Pi("th",gg,v).textContent=We}else hi(St,S1),ft.live&&hi(St,b1);let Oe={show:!0},rn={show:!1};function Ie(v,T){if(T==0&&(ae||!ft.live||s==2))return bo;let D=[],O=Pi("tr",M1,Ht,Ht.childNodes[T]);hi(O,v.class),v.show||hi(O,yr);let W=Pi("th",null,O);if(gt.show){let pt=xi(w1,W);if(T>0){let vt=gt.width(i,T);vt&&(pt.style.border=vt+"px "+gt.dash(i,T)+" "+gt.stroke(i,T)),pt.style.background=gt.fill(i,T)}}let J=xi(gg,W);v.label instanceof HTMLElement?J.appendChild(v.label):J.textContent=v.label,T>0&&(gt.show||(J.style.color=v.width>0?gt.stroke(i,T):gt.fill(i,T)),ye("click",W,pt=>{if(dt._lock)return;Kt(pt);let vt=x.indexOf(v);if((pt.ctrlKey||pt.metaKey)!=ft.isolate){let Nt=x.some((Dt,Ot)=>Ot>0&&Ot!=vt&&Dt.show);x.forEach((Dt,Ot)=>{Ot>0&&Oi(Ot,Nt?Ot==vt?Oe:rn:Oe,!0,hn.setSeries)})}else Oi(vt,{show:!v.show},!0,hn.setSeries)},!1),Jt&&ye(vg,W,pt=>{dt._lock||(Kt(pt),Oi(x.indexOf(v),Lr,!0,hn.setSeries))},!1));for(var at in he){let pt=Pi("td",A1,O);pt.textContent="--",D.push(pt)}return[O,D]}let Mn=new Map;function ye(v,T,D,O=!0){let W=Mn.get(T)||{},J=dt.bind[v](i,T,D,O);J&&(vr(v,T,W[v]=J),Mn.set(T,W))}function pn(v,T,D){let O=Mn.get(T)||{};for(let W in O)(v==null||W==v)&&(Ld(W,T,O[W]),delete O[W]);v==null&&Mn.delete(T)}let Ye=0,on=0,B=0,Rt=0,qt=0,re=0,wt=qt,Ne=re,zt=B,Xt=Rt,L=0,w=0,$=0,ht=0;i.bbox={};let ot=!1,xt=!1,yt=!1,et=!1,st=!1,mt=!1;function k(v,T,D){(D||v!=i.width||T!=i.height)&&rt(v,T),le(!1),yt=!0,xt=!0,Nn()}function rt(v,T){i.width=Ye=B=v,i.height=on=Rt=T,qt=re=0,bt(),Gt();let D=i.bbox;L=D.left=_r(qt*we,.5),w=D.top=_r(re*we,.5),$=D.width=_r(B*we,.5),ht=D.height=_r(Rt*we,.5)}let nt=3;function At(){let v=!1,T=0;for(;!v;){T++;let D=Tr(T),O=Ui(T);v=T==nt||D&&O,v||(rt(i.width,i.height),xt=!0)}}function _t({width:v,height:T}){k(v,T)}i.setSize=_t;function bt(){let v=!1,T=!1,D=!1,O=!1;A.forEach((W,J)=>{if(W.show&&W._show){let{side:at,_size:pt}=W,vt=at%2,Nt=W.label!=null?W.labelSize:0,Dt=pt+Nt;Dt>0&&(vt?(B-=Dt,at==3?(qt+=Dt,O=!0):D=!0):(Rt-=Dt,at==0?(re+=Dt,v=!0):T=!0))}}),Ni[0]=v,Ni[1]=D,Ni[2]=T,Ni[3]=O,B-=vi[1]+vi[3],qt+=vi[3],Rt-=vi[2]+vi[0],re+=vi[0]}function Gt(){let v=qt+B,T=re+Rt,D=qt,O=re;function W(J,at){switch(J){case 1:return v+=at,v-at;case 2:return T+=at,T-at;case 3:return D-=at,D+at;case 0:return O-=at,O+at}}A.forEach((J,at)=>{if(J.show&&J._show){let pt=J.side;J._pos=W(pt,J._size),J.label!=null&&(J._lpos=W(pt,J.labelSize))}})}if(dt.dataIdx==null){let v=dt.hover,T=v.skip=new Set(v.skip??[]);T.add(void 0);let D=v.prox=xe(v.prox),O=v.bias??=0;dt.dataIdx=(W,J,at,pt)=>{if(J==0)return at;let vt=at,Nt=D(W,J,at,pt)??De,Dt=Nt>=0&&Nt<De,Ot=R.ori==0?B:Rt,ie=dt.left,Se=t[0],ve=t[J];if(T.has(ve[at])){vt=null;let me=null,Zt=null,Wt;if(O==0||O==-1)for(Wt=at;me==null&&Wt-- >0;)T.has(ve[Wt])||(me=Wt);if(O==0||O==1)for(Wt=at;Zt==null&&Wt++<ve.length;)T.has(ve[Wt])||(Zt=Wt);if(me!=null||Zt!=null)if(Dt){let Ve=me==null?-1/0:z(Se[me],R,Ot,0),Je=Zt==null?1/0:z(Se[Zt],R,Ot,0),En=ie-Ve,Le=Je-ie;En<=Le?En<=Nt&&(vt=me):Le<=Nt&&(vt=Zt)}else vt=Zt==null?me:me==null?Zt:at-me<=Zt-at?me:Zt}else Dt&&Sn(ie-z(Se[at],R,Ot,0))>Nt&&(vt=null);return vt}}let Kt=v=>{dt.event=v};dt.idxs=it,dt._lock=!1;let ct=dt.points;ct.show=xe(ct.show),ct.size=xe(ct.size),ct.stroke=xe(ct.stroke),ct.width=xe(ct.width),ct.fill=xe(ct.fill);let Ft=i.focus=fn({},n.focus||{alpha:.3},dt.focus),Jt=Ft.prox>=0,Ct=Jt&&ct.one,oe=[],ke=[],Bn=[];function Io(v,T){let D=ct.show(i,T);if(D instanceof HTMLElement)return hi(D,y1),hi(D,v.class),Ki(D,-10,-10,B,Rt),m.insertBefore(D,oe[T]),D}function Mr(v,T){if(s==1||T>0){let D=s==1&&b[v.scale].time,O=v.value;v.value=D?Ug(O)?Gg(q,Vg(O,H)):O||Q:O||NA,v.label=v.label||(D?AA:wA)}if(Ct||T>0){v.width=v.width==null?1:v.width,v.paths=v.paths||qA||F1,v.fillTo=xe(v.fillTo||kA),v.pxAlign=+be(v.pxAlign,_),v.pxRound=Jg(v.pxAlign),v.stroke=xe(v.stroke||null),v.fill=xe(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let D=DA(Yn(1,v.width),1),O=v.points=fn({},{size:D,width:Yn(1,D*.2),stroke:v.stroke,space:D*2,paths:YA,_stroke:null,_fill:null},v.points);O.show=xe(O.show),O.filter=xe(O.filter),O.fill=xe(O.fill),O.stroke=xe(O.stroke),O.paths=xe(O.paths),O.pxAlign=v.pxAlign}if(tt){let D=Ie(v,T);se.splice(T,0,D[0]),Vt.splice(T,0,D[1]),ft.values.push(null)}if(ut){it.splice(T,0,null);let D=null;Ct?T==0&&(D=Io(v,T)):T>0&&(D=Io(v,T)),oe.splice(T,0,D),ke.splice(T,0,0),Bn.splice(T,0,0)}Tn("addSeries",T)}function Nh(v,T){T=T??x.length,v=s==1?kd(v,T,Wg,Zg):kd(v,T,{},Yg),x.splice(T,0,v),Mr(x[T],T)}i.addSeries=Nh;function Xa(v){if(x.splice(v,1),tt){ft.values.splice(v,1),Vt.splice(v,1);let T=se.splice(v,1)[0];pn(null,T.firstChild),T.remove()}ut&&(it.splice(v,1),oe.splice(v,1)[0].remove(),ke.splice(v,1),Bn.splice(v,1)),Tn("delSeries",v)}i.delSeries=Xa;let Ni=[!1,!1,!1,!1];function ji(v,T){if(v._show=v.show,v.show){let D=v.side%2,O=b[v.scale];O==null&&(v.scale=D?x[1].scale:M,O=b[v.scale]);let W=O.time;v.size=xe(v.size),v.space=xe(v.space),v.rotate=xe(v.rotate),Ks(v.incrs)&&v.incrs.forEach(at=>{!Js.has(at)&&Js.set(at,h0(at))}),v.incrs=xe(v.incrs||(O.distr==2?rA:W?g==1?aA:hA:xr)),v.splits=xe(v.splits||(W&&O.distr==1?lt:O.distr==3?Dd:O.distr==4?CA:EA)),v.stroke=xe(v.stroke),v.grid.stroke=xe(v.grid.stroke),v.ticks.stroke=xe(v.ticks.stroke),v.border.stroke=xe(v.border.stroke);let J=v.values;v.values=Ks(J)&&!Ks(J[0])?xe(J):W?Ks(J)?zg(q,Bg(J,H)):Ug(J)?fA(q,J):J||K:J||TA,v.filter=xe(v.filter||(O.distr>=3&&O.log==10?IA:O.distr==3&&O.log==2?LA:l0)),v.font=e0(v.font),v.labelFont=e0(v.labelFont),v._size=v.size(i,null,T,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(Ni[T]=!0,v._el=xi(m1,d))}}function Qi(v,T,D,O){let[W,J,at,pt]=D,vt=T%2,Nt=0;return vt==0&&(pt||J)&&(Nt=T==0&&!W||T==2&&!at?bn(Hg.size/3):0),vt==1&&(W||at)&&(Nt=T==1&&!J||T==3&&!pt?bn($g.size/2):0),Nt}let Lo=i.padding=(n.padding||[Qi,Qi,Qi,Qi]).map(v=>xe(be(v,Qi))),vi=i._padding=Lo.map((v,T)=>v(i,T,Ni,0)),Ze,tn=null,en=null,Di=s==1?x[0].idxs:null,jn=null,ws=!1;function No(v,T){if(t=v??[],i.data=i._data=t,s==2){Ze=0;for(let D=1;D<x.length;D++)Ze+=t[D][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),jn=t[0],Ze=jn.length;let D=t;if(F==2){D=t.slice();let O=D[0]=Array(Ze);for(let W=0;W<Ze;W++)O[W]=W}i._data=t=D}if(le(!0),Tn("setData"),F==2&&(yt=!0),T!==!1){let D=R;D.auto(i,ws)?Do():Es(M,D.min,D.max),et=et||dt.left>=0,mt=!0,Nn()}}i.setData=No;function Do(){ws=!0;let v,T;s==1&&(Ze>0?(tn=Di[0]=0,en=Di[1]=Ze-1,v=t[0][tn],T=t[0][en],F==2?(v=tn,T=en):v==T&&(F==3?[v,T]=dh(v,v,R.log,!1):F==4?[v,T]=Gd(v,v,R.log,!1):R.time?T=v+bn(86400/g):[v,T]=ch(v,T,Hd,!0))):(tn=Di[0]=v=null,en=Di[1]=T=null)),Es(M,v,T)}let wr,As,Ar,E,V,j,Y,Z,Tt,Pt;function Et(v,T,D,O,W,J){v??=xg,D??=Xd,O??="butt",W??=xg,J??="round",v!=wr&&(u.strokeStyle=wr=v),W!=As&&(u.fillStyle=As=W),T!=Ar&&(u.lineWidth=Ar=T),J!=V&&(u.lineJoin=V=J),O!=j&&(u.lineCap=j=O),D!=E&&u.setLineDash(E=D)}function It(v,T,D,O){T!=As&&(u.fillStyle=As=T),v!=Y&&(u.font=Y=v),D!=Z&&(u.textAlign=Z=D),O!=Tt&&(u.textBaseline=Tt=O)}function Bt(v,T,D,O,W=0){if(O.length>0&&v.auto(i,ws)&&(T==null||T.min==null)){let J=be(tn,0),at=be(en,O.length-1),pt=D.min==null?I1(O,J,at,W,v.distr==3):[D.min,D.max];v.min=Li(v.min,D.min=pt[0]),v.max=Yn(v.max,D.max=pt[1])}}let te={min:null,max:null};function ue(){for(let O in b){let W=b[O];G[O]==null&&(W.min==null||G[M]!=null&&W.auto(i,ws))&&(G[O]=te)}for(let O in b){let W=b[O];G[O]==null&&W.from!=null&&G[W.from]!=null&&(G[O]=te)}G[M]!=null&&le(!0);let v={};for(let O in G){let W=G[O];if(W!=null){let J=v[O]=So(b[O],z1);if(W.min!=null)fn(J,W);else if(O!=M||s==2)if(Ze==0&&J.from==null){let at=J.range(i,null,null,O);J.min=at[0],J.max=at[1]}else J.min=De,J.max=-De}}if(Ze>0){x.forEach((O,W)=>{if(s==1){let J=O.scale,at=G[J];if(at==null)return;let pt=v[J];if(W==0){let vt=pt.range(i,pt.min,pt.max,J);pt.min=vt[0],pt.max=vt[1],tn=Ii(pt.min,t[0]),en=Ii(pt.max,t[0]),en-tn>1&&(t[0][tn]<pt.min&&tn++,t[0][en]>pt.max&&en--),O.min=jn[tn],O.max=jn[en]}else O.show&&O.auto&&Bt(pt,at,O,t[W],O.sorted);O.idxs[0]=tn,O.idxs[1]=en}else if(W>0&&O.show&&O.auto){let[J,at]=O.facets,pt=J.scale,vt=at.scale,[Nt,Dt]=t[W],Ot=v[pt],ie=v[vt];Ot!=null&&Bt(Ot,G[pt],J,Nt,J.sorted),ie!=null&&Bt(ie,G[vt],at,Dt,at.sorted),O.min=at.min,O.max=at.max}});for(let O in v){let W=v[O],J=G[O];if(W.from==null&&(J==null||J.min==null)){let at=W.range(i,W.min==De?null:W.min,W.max==-De?null:W.max,O);W.min=at[0],W.max=at[1]}}}for(let O in v){let W=v[O];if(W.from!=null){let J=v[W.from];if(J.min==null)W.min=W.max=null;else{let at=W.range(i,J.min,J.max,O);W.min=at[0],W.max=at[1]}}}let T={},D=!1;for(let O in v){let W=v[O],J=b[O];if(J.min!=W.min||J.max!=W.max){J.min=W.min,J.max=W.max;let at=J.distr;J._min=at==3?vs(J.min):at==4?Ad(J.min,J.asinh):at==100?J.fwd(J.min):J.min,J._max=at==3?vs(J.max):at==4?Ad(J.max,J.asinh):at==100?J.fwd(J.max):J.max,T[O]=D=!0}}if(D){x.forEach((O,W)=>{s==2?W>0&&T.y&&(O._paths=null):T[O.scale]&&(O._paths=null)});for(let O in T)yt=!0,Tn("setScale",O);ut&&dt.left>=0&&(et=mt=!0)}for(let O in G)G[O]=null}function kt(v){let T=Nd(tn-1,0,Ze-1),D=Nd(en+1,0,Ze-1);for(;v[T]==null&&T>0;)T--;for(;v[D]==null&&D<Ze-1;)D++;return[T,D]}function de(){if(Ze>0){let v=x.some(T=>T._focus)&&Pt!=Ft.alpha;v&&(u.globalAlpha=Pt=Ft.alpha),x.forEach((T,D)=>{if(D>0&&T.show&&(qe(D,!1),qe(D,!0),T._paths==null)){let O=Pt;Pt!=T.alpha&&(u.globalAlpha=Pt=T.alpha);let W=s==2?[0,t[D][0].length-1]:kt(t[D]);T._paths=T.paths(i,D,W[0],W[1]),Pt!=O&&(u.globalAlpha=Pt=O)}}),x.forEach((T,D)=>{if(D>0&&T.show){let O=Pt;Pt!=T.alpha&&(u.globalAlpha=Pt=T.alpha),T._paths!=null&&Ee(D,!1);{let W=T._paths!=null?T._paths.gaps:null,J=T.points.show(i,D,tn,en,W),at=T.points.filter(i,D,J,W);(J||at)&&(T.points._paths=T.points.paths(i,D,tn,en,at),Ee(D,!0))}Pt!=O&&(u.globalAlpha=Pt=O),Tn("drawSeries",D)}}),v&&(u.globalAlpha=Pt=1)}}function qe(v,T){let D=T?x[v].points:x[v];D._stroke=D.stroke(i,v),D._fill=D.fill(i,v)}function Ee(v,T){let D=T?x[v].points:x[v],{stroke:O,fill:W,clip:J,flags:at,_stroke:pt=D._stroke,_fill:vt=D._fill,_width:Nt=D.width}=D._paths;Nt=Ue(Nt*we,3);let Dt=null,Ot=Nt%2/2;T&&vt==null&&(vt=Nt>0?"#fff":pt);let ie=D.pxAlign==1&&Ot>0;if(ie&&u.translate(Ot,Ot),!T){let Se=L-Nt/2,ve=w-Nt/2,me=$+Nt,Zt=ht+Nt;Dt=new Path2D,Dt.rect(Se,ve,me,Zt)}T?Ut(pt,Nt,D.dash,D.cap,vt,O,W,at,J):Ce(v,pt,Nt,D.dash,D.cap,vt,O,W,at,Dt,J),ie&&u.translate(-Ot,-Ot)}function Ce(v,T,D,O,W,J,at,pt,vt,Nt,Dt){let Ot=!1;vt!=0&&C.forEach((ie,Se)=>{if(ie.series[0]==v){let ve=x[ie.series[1]],me=t[ie.series[1]],Zt=(ve._paths||Va).band;Ks(Zt)&&(Zt=ie.dir==1?Zt[0]:Zt[1]);let Wt,Ve=null;ve.show&&Zt&&N1(me,tn,en)?(Ve=ie.fill(i,Se)||J,Wt=ve._paths.clip):Zt=null,Ut(T,D,O,W,Ve,at,pt,vt,Nt,Dt,Wt,Zt),Ot=!0}}),Ot||Ut(T,D,O,W,J,at,pt,vt,Nt,Dt)}let mn=Mo|Od;function Ut(v,T,D,O,W,J,at,pt,vt,Nt,Dt,Ot){Et(v,T,D,O,W),(vt||Nt||Ot)&&(u.save(),vt&&u.clip(vt),Nt&&u.clip(Nt)),Ot?(pt&mn)==mn?(u.clip(Ot),Dt&&u.clip(Dt),ge(W,at),an(v,J,T)):pt&Od?(ge(W,at),u.clip(Ot),an(v,J,T)):pt&Mo&&(u.save(),u.clip(Ot),Dt&&u.clip(Dt),ge(W,at),u.restore(),an(v,J,T)):(ge(W,at),an(v,J,T)),(vt||Nt||Ot)&&u.restore()}function an(v,T,D){D>0&&(T instanceof Map?T.forEach((O,W)=>{u.strokeStyle=wr=W,u.stroke(O)}):T!=null&&v&&u.stroke(T))}function ge(v,T){T instanceof Map?T.forEach((D,O)=>{u.fillStyle=As=O,u.fill(D)}):T!=null&&v&&u.fill(T)}function ts(v,T,D,O){let W=A[v],J;if(O<=0)J=[0,0];else{let at=W._space=W.space(i,v,T,D,O),pt=W._incrs=W.incrs(i,v,T,D,O,at);J=tT(T,D,pt,O,at)}return W._found=J}function ln(v,T,D,O,W,J,at,pt,vt,Nt){let Dt=at%2/2;_==1&&u.translate(Dt,Dt),Et(pt,at,vt,Nt,pt),u.beginPath();let Ot,ie,Se,ve,me=W+(O==0||O==3?-J:J);D==0?(ie=W,ve=me):(Ot=W,Se=me);for(let Zt=0;Zt<v.length;Zt++)T[Zt]!=null&&(D==0?Ot=Se=v[Zt]:ie=ve=v[Zt],u.moveTo(Ot,ie),u.lineTo(Se,ve));u.stroke(),_==1&&u.translate(-Dt,-Dt)}function Tr(v){let T=!0;return A.forEach((D,O)=>{if(!D.show)return;let W=b[D.scale];if(W.min==null){D._show&&(T=!1,D._show=!1,le(!1));return}else D._show||(T=!1,D._show=!0,le(!1));let J=D.side,at=J%2,{min:pt,max:vt}=W,[Nt,Dt]=ts(O,pt,vt,at==0?B:Rt);if(Dt==0)return;let Ot=W.distr==2,ie=D._splits=D.splits(i,O,pt,vt,Nt,Dt,Ot),Se=W.distr==2?ie.map(Wt=>jn[Wt]):ie,ve=W.distr==2?jn[ie[1]]-jn[ie[0]]:Nt,me=D._values=D.values(i,D.filter(i,Se,O,Dt,ve),O,Dt,ve);D._rotate=J==2?D.rotate(i,me,O,Dt):0;let Zt=D._size;D._size=yi(D.size(i,me,O,v)),Zt!=null&&D._size!=Zt&&(T=!1)}),T}function Ui(v){let T=!0;return Lo.forEach((D,O)=>{let W=D(i,O,Ni,v);W!=vi[O]&&(T=!1),vi[O]=W}),T}function es(){for(let v=0;v<A.length;v++){let T=A[v];if(!T.show||!T._show)continue;let D=T.side,O=D%2,W,J,at=T.stroke(i,v),pt=D==0||D==3?-1:1,[vt,Nt]=T._found;if(T.label!=null){let Gn=T.labelGap*pt,ei=bn((T._lpos+Gn)*we);It(T.labelFont[0],at,"center",D==2?"top":_g),u.save(),O==1?(W=J=0,u.translate(ei,bn(w+ht/2)),u.rotate((D==3?-ah:ah)/2)):(W=bn(L+$/2),J=ei);let er=o0(T.label)?T.label(i,v,vt,Nt):T.label;u.fillText(er,W,J),u.restore()}if(Nt==0)continue;let Dt=b[T.scale],Ot=O==0?$:ht,ie=O==0?L:w,Se=T._splits,ve=Dt.distr==2?Se.map(Gn=>jn[Gn]):Se,me=Dt.distr==2?jn[Se[1]]-jn[Se[0]]:vt,Zt=T.ticks,Wt=T.border,Ve=Zt.show?Zt.size:0,Je=bn(Ve*we),En=bn((T.alignTo==2?T._size-Ve-T.gap:T.gap)*we),Le=T._rotate*-ah/180,je=p(T._pos*we),Qn=(Je+En)*pt,Vn=je+Qn;J=O==0?Vn:0,W=O==1?Vn:0;let fi=T.font[0],bi=T.align==1?_o:T.align==2?Sd:Le>0?_o:Le<0?Sd:O==0?"center":D==3?Sd:_o,ki=Le||O==1?"middle":D==2?"top":_g;It(fi,at,bi,ki);let ti=T.font[1]*T.lineGap,pi=Se.map(Gn=>p(a(Gn,Dt,Ot,ie))),Si=T._values;for(let Gn=0;Gn<Si.length;Gn++){let ei=Si[Gn];if(ei!=null){O==0?W=pi[Gn]:J=pi[Gn],ei=""+ei;let er=ei.indexOf(`
`)==-1?[ei]:ei.split(/\n/gm);for(let Hn=0;Hn<er.length;Hn++){let Df=er[Hn];Le?(u.save(),u.translate(W,J+Hn*ti),u.rotate(Le),u.fillText(Df,0,0),u.restore()):u.fillText(Df,W,J+Hn*ti)}}}Zt.show&&ln(pi,Zt.filter(i,ve,v,Nt,me),O,D,je,Je,Ue(Zt.width*we,3),Zt.stroke(i,v),Zt.dash,Zt.cap);let Bi=T.grid;Bi.show&&ln(pi,Bi.filter(i,ve,v,Nt,me),O,O==0?2:1,O==0?w:L,O==0?ht:$,Ue(Bi.width*we,3),Bi.stroke(i,v),Bi.dash,Bi.cap),Wt.show&&ln([je],[1],O==0?1:0,O==0?1:2,O==1?w:L,O==1?ht:$,Ue(Wt.width*we,3),Wt.stroke(i,v),Wt.dash,Wt.cap)}Tn("drawAxes")}function le(v){x.forEach((T,D)=>{D>0&&(T._paths=null,v&&(s==1?(T.min=null,T.max=null):T.facets.forEach(O=>{O.min=null,O.max=null})))})}let Ke=!1,zn=!1,Re=[];function cn(){zn=!1;for(let v=0;v<Re.length;v++)Tn(...Re[v]);Re.length=0}function Nn(){Ke||(q1(gf),Ke=!0)}function $a(v,T=!1){Ke=!0,zn=T,v(i),gf(),T&&Re.length>0&&queueMicrotask(cn)}i.batch=$a;function gf(){if(ot&&(ue(),ot=!1),yt&&(At(),yt=!1),xt){if(He(f,_o,qt),He(f,"top",re),He(f,Fa,B),He(f,ka,Rt),He(m,_o,qt),He(m,"top",re),He(m,Fa,B),He(m,ka,Rt),He(d,Fa,Ye),He(d,ka,on),h.width=bn(Ye*we),h.height=bn(on*we),A.forEach(({_el:v,_show:T,_size:D,_pos:O,side:W})=>{if(v!=null)if(T){let J=W===3||W===0?D:0,at=W%2==1;He(v,at?"left":"top",O-J),He(v,at?"width":"height",D),He(v,at?"top":"left",at?re:qt),He(v,at?"height":"width",at?Rt:B),Id(v,yr)}else hi(v,yr)}),wr=As=Ar=V=j=Y=Z=Tt=E=null,Pt=1,Fo(!0),qt!=wt||re!=Ne||B!=zt||Rt!=Xt){le(!1);let v=B/zt,T=Rt/Xt;if(ut&&!et&&dt.left>=0){dt.left*=v,dt.top*=T,Er&&Ki(Er,bn(dt.left),0,B,Rt),Cr&&Ki(Cr,0,bn(dt.top),B,Rt);for(let D=0;D<oe.length;D++){let O=oe[D];O!=null&&(ke[D]*=v,Bn[D]*=T,Ki(O,yi(ke[D]),yi(Bn[D]),B,Rt))}}if(ze.show&&!st&&ze.left>=0&&ze.width>0){ze.left*=v,ze.width*=v,ze.top*=T,ze.height*=T;for(let D in Bh)He(Ir,D,ze[D])}wt=qt,Ne=re,zt=B,Xt=Rt}Tn("setSize"),xt=!1}Ye>0&&on>0&&(u.clearRect(0,0,h.width,h.height),Tn("drawClear"),S.forEach(v=>v()),Tn("draw")),ze.show&&st&&(qa(ze),st=!1),ut&&et&&(tr(null,!0,!1),et=!1),ft.show&&ft.live&&mt&&(Fh(),mt=!1),l||(l=!0,i.status=1,Tn("ready")),ws=!1,Ke=!1}i.redraw=(v,T)=>{yt=T||!1,v!==!1?Es(M,R.min,R.max):Nn()};function Dh(v,T){let D=b[v];if(D.from==null){if(Ze==0){let O=D.range(i,T.min,T.max,v);T.min=O[0],T.max=O[1]}if(T.min>T.max){let O=T.min;T.min=T.max,T.max=O}if(Ze>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;v==M&&D.distr==2&&Ze>0&&(T.min=Ii(T.min,t[0]),T.max=Ii(T.max,t[0]),T.min==T.max&&T.max++),G[v]=T,ot=!0,Nn()}}i.setScale=Dh;let Uh,Oh,Er,Cr,_f,xf,Rr,Pr,yf,vf,Be,Xe,Ts=!1,Pn=dt.drag,wn=Pn.x,An=Pn.y;ut&&(dt.x&&(Uh=xi(_1,m)),dt.y&&(Oh=xi(x1,m)),R.ori==0?(Er=Uh,Cr=Oh):(Er=Oh,Cr=Uh),Be=dt.left,Xe=dt.top);let ze=i.select=fn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Ir=ze.show?xi(g1,ze.over?m:f):null;function qa(v,T){if(ze.show){for(let D in v)ze[D]=v[D],D in Bh&&He(Ir,D,v[D]);T!==!1&&Tn("setSelect")}}i.setSelect=qa;function J_(v){if(x[v].show)tt&&Id(se[v],yr);else if(tt&&hi(se[v],yr),ut){let D=Ct?oe[0]:oe[v];D!=null&&Ki(D,-10,-10,B,Rt)}}function Es(v,T,D){Dh(v,{min:T,max:D})}function Oi(v,T,D,O){T.focus!=null&&nx(v),T.show!=null&&x.forEach((W,J)=>{J>0&&(v==J||v==null)&&(W.show=T.show,J_(J),s==2?(Es(W.facets[0].scale,null,null),Es(W.facets[1].scale,null,null)):Es(W.scale,null,null),Nn())}),D!==!1&&Tn("setSeries",v,T),O&&ko("setSeries",i,v,T)}i.setSeries=Oi;function j_(v,T){fn(C[v],T)}function Q_(v,T){v.fill=xe(v.fill||null),v.dir=be(v.dir,-1),T=T??C.length,C.splice(T,0,v)}function tx(v){v==null?C.length=0:C.splice(v,1)}i.addBand=Q_,i.setBand=j_,i.delBand=tx;function ex(v,T){x[v].alpha=T,ut&&oe[v]!=null&&(oe[v].style.opacity=T),tt&&se[v]&&(se[v].style.opacity=T)}let ns,Cs,Qs,Lr={focus:!0};function nx(v){if(v!=Qs){let T=v==null,D=Ft.alpha!=1;x.forEach((O,W)=>{if(s==1||W>0){let J=T||W==0||W==v;O._focus=T?null:J,D&&ex(W,J?1:Ft.alpha)}}),Qs=v,D&&Nn()}}tt&&Jt&&ye(bg,St,v=>{dt._lock||(Kt(v),Qs!=null&&Oi(null,Lr,!0,hn.setSeries))});function Fi(v,T,D){let O=b[T];D&&(v=v/we-(O.ori==1?re:qt));let W=B;O.ori==1&&(W=Rt,v=W-v),O.dir==-1&&(v=W-v);let J=O._min,at=O._max,pt=v/W,vt=J+(at-J)*pt,Nt=O.distr;return Nt==3?vo(10,vt):Nt==4?U1(vt,O.asinh):Nt==100?O.bwd(vt):vt}function ix(v,T){let D=Fi(v,M,T);return Ii(D,t[0],tn,en)}i.valToIdx=v=>Ii(v,t[0]),i.posToIdx=ix,i.posToVal=Fi,i.valToPos=(v,T,D)=>b[T].ori==0?r(v,b[T],D?$:B,D?L:0):o(v,b[T],D?ht:Rt,D?w:0),i.setCursor=(v,T,D)=>{Be=v.left,Xe=v.top,tr(null,T,D)};function bf(v,T){He(Ir,_o,ze.left=v),He(Ir,Fa,ze.width=T)}function Sf(v,T){He(Ir,"top",ze.top=v),He(Ir,ka,ze.height=T)}let Uo=R.ori==0?bf:Sf,Oo=R.ori==1?bf:Sf;function sx(){if(tt&&ft.live)for(let v=s==2?1:0;v<x.length;v++){if(v==0&&ae)continue;let T=ft.values[v],D=0;for(let O in T)Vt[v][D++].firstChild.nodeValue=T[O]}}function Fh(v,T){if(v!=null&&(v.idxs?v.idxs.forEach((D,O)=>{it[O]=D}):B1(v.idx)||it.fill(v.idx),ft.idx=it[0]),tt&&ft.live){for(let D=0;D<x.length;D++)(D>0||s==1&&!ae)&&rx(D,it[D]);sx()}mt=!1,T!==!1&&Tn("setLegend")}i.setLegend=Fh;function rx(v,T){let D=x[v],O=v==0&&F==2?jn:t[v],W;ae?W=D.values(i,v,T)??ne:(W=D.value(i,T==null?null:O[T],v,T),W=W==null?ne:{_:W}),ft.values[v]=W}function tr(v,T,D){yf=Be,vf=Xe,[Be,Xe]=dt.move(i,Be,Xe),dt.left=Be,dt.top=Xe,ut&&(Er&&Ki(Er,bn(Be),0,B,Rt),Cr&&Ki(Cr,0,bn(Xe),B,Rt));let O,W=tn>en;ns=De,Cs=null;let J=R.ori==0?B:Rt,at=R.ori==1?B:Rt;if(Be<0||Ze==0||W){O=dt.idx=null;for(let pt=0;pt<x.length;pt++){let vt=oe[pt];vt!=null&&Ki(vt,-10,-10,B,Rt)}Jt&&Oi(null,Lr,!0,v==null&&hn.setSeries),ft.live&&(it.fill(O),mt=!0)}else{let pt,vt,Nt;s==1&&(pt=R.ori==0?Be:Xe,vt=Fi(pt,M),O=dt.idx=Ii(vt,t[0],tn,en),Nt=z(t[0][O],R,J,0));let Dt=-10,Ot=-10,ie=0,Se=0,ve=!0,me="",Zt="";for(let Wt=s==2?1:0;Wt<x.length;Wt++){let Ve=x[Wt],Je=it[Wt],En=Je==null?null:s==1?t[Wt][Je]:t[Wt][1][Je],Le=dt.dataIdx(i,Wt,O,vt),je=Le==null?null:s==1?t[Wt][Le]:t[Wt][1][Le];if(mt=mt||je!=En||Le!=Je,it[Wt]=Le,Wt>0&&Ve.show){let Qn=Le==null?-10:Le==O?Nt:z(s==1?t[0][Le]:t[Wt][0][Le],R,J,0),Vn=je==null?-10:U(je,s==1?b[Ve.scale]:b[Ve.facets[1].scale],at,0);if(Jt&&je!=null){let fi=R.ori==1?Be:Xe,bi=Sn(Ft.dist(i,Wt,Le,Vn,fi));if(bi<ns){let ki=Ft.bias;if(ki!=0){let ti=Fi(fi,Ve.scale),pi=je>=0?1:-1,Si=ti>=0?1:-1;Si==pi&&(Si==1?ki==1?je>=ti:je<=ti:ki==1?je<=ti:je>=ti)&&(ns=bi,Cs=Wt)}else ns=bi,Cs=Wt}}if(mt||Ct){let fi,bi;R.ori==0?(fi=Qn,bi=Vn):(fi=Vn,bi=Qn);let ki,ti,pi,Si,Bi,Gn,ei=!0,er=ct.bbox;if(er!=null){ei=!1;let Hn=er(i,Wt);pi=Hn.left,Si=Hn.top,ki=Hn.width,ti=Hn.height}else pi=fi,Si=bi,ki=ti=ct.size(i,Wt);if(Gn=ct.fill(i,Wt),Bi=ct.stroke(i,Wt),Ct)Wt==Cs&&ns<=Ft.prox&&(Dt=pi,Ot=Si,ie=ki,Se=ti,ve=ei,me=Gn,Zt=Bi);else{let Hn=oe[Wt];Hn!=null&&(ke[Wt]=pi,Bn[Wt]=Si,Cg(Hn,ki,ti,ei),Tg(Hn,Gn,Bi),Ki(Hn,yi(pi),yi(Si),B,Rt))}}}}if(Ct){let Wt=Ft.prox,Ve=Qs==null?ns<=Wt:ns>Wt||Cs!=Qs;if(mt||Ve){let Je=oe[0];Je!=null&&(ke[0]=Dt,Bn[0]=Ot,Cg(Je,ie,Se,ve),Tg(Je,me,Zt),Ki(Je,yi(Dt),yi(Ot),B,Rt))}}}if(ze.show&&Ts)if(v!=null){let[pt,vt]=hn.scales,[Nt,Dt]=hn.match,[Ot,ie]=v.cursor.sync.scales,Se=v.cursor.drag;if(wn=Se._x,An=Se._y,wn||An){let{left:ve,top:me,width:Zt,height:Wt}=v.select,Ve=v.scales[Ot].ori,Je=v.posToVal,En,Le,je,Qn,Vn,fi=pt!=null&&Nt(pt,Ot),bi=vt!=null&&Dt(vt,ie);fi&&wn?(Ve==0?(En=ve,Le=Zt):(En=me,Le=Wt),je=b[pt],Qn=z(Je(En,Ot),je,J,0),Vn=z(Je(En+Le,Ot),je,J,0),Uo(Li(Qn,Vn),Sn(Vn-Qn))):Uo(0,J),bi&&An?(Ve==1?(En=ve,Le=Zt):(En=me,Le=Wt),je=b[vt],Qn=U(Je(En,ie),je,at,0),Vn=U(Je(En+Le,ie),je,at,0),Oo(Li(Qn,Vn),Sn(Vn-Qn))):Oo(0,at)}else zh()}else{let pt=Sn(yf-_f),vt=Sn(vf-xf);if(R.ori==1){let ie=pt;pt=vt,vt=ie}wn=Pn.x&&pt>=Pn.dist,An=Pn.y&&vt>=Pn.dist;let Nt=Pn.uni;Nt!=null?wn&&An&&(wn=pt>=Nt,An=vt>=Nt,!wn&&!An&&(vt>pt?An=!0:wn=!0)):Pn.x&&Pn.y&&(wn||An)&&(wn=An=!0);let Dt,Ot;wn&&(R.ori==0?(Dt=Rr,Ot=Be):(Dt=Pr,Ot=Xe),Uo(Li(Dt,Ot),Sn(Ot-Dt)),An||Oo(0,at)),An&&(R.ori==1?(Dt=Rr,Ot=Be):(Dt=Pr,Ot=Xe),Oo(Li(Dt,Ot),Sn(Ot-Dt)),wn||Uo(0,J)),!wn&&!An&&(Uo(0,0),Oo(0,0))}if(Pn._x=wn,Pn._y=An,v==null){if(D){if(Nf!=null){let[pt,vt]=hn.scales;hn.values[0]=pt!=null?Fi(R.ori==0?Be:Xe,pt):null,hn.values[1]=vt!=null?Fi(R.ori==1?Be:Xe,vt):null}ko(Md,i,Be,Xe,B,Rt,O)}if(Jt){let pt=D&&hn.setSeries,vt=Ft.prox;Qs==null?ns<=vt&&Oi(Cs,Lr,!0,pt):ns>vt?Oi(null,Lr,!0,pt):Cs!=Qs&&Oi(Cs,Lr,!0,pt)}}mt&&(ft.idx=O,Fh()),T!==!1&&Tn("setCursor")}let Rs=null;Object.defineProperty(i,"rect",{get(){return Rs==null&&Fo(!1),Rs}});function Fo(v=!1){v?Rs=null:(Rs=m.getBoundingClientRect(),Tn("syncRect",Rs))}function Mf(v,T,D,O,W,J,at){dt._lock||Ts&&v!=null&&v.movementX==0&&v.movementY==0||(kh(v,T,D,O,W,J,at,!1,v!=null),v!=null?tr(null,!0,!0):tr(T,!0,!1))}function kh(v,T,D,O,W,J,at,pt,vt){if(Rs==null&&Fo(!1),Kt(v),v!=null)D=v.clientX-Rs.left,O=v.clientY-Rs.top;else{if(D<0||O<0){Be=-10,Xe=-10;return}let[Nt,Dt]=hn.scales,Ot=T.cursor.sync,[ie,Se]=Ot.values,[ve,me]=Ot.scales,[Zt,Wt]=hn.match,Ve=T.axes[0].side%2==1,Je=R.ori==0?B:Rt,En=R.ori==1?B:Rt,Le=Ve?J:W,je=Ve?W:J,Qn=Ve?O:D,Vn=Ve?D:O;if(ve!=null?D=Zt(Nt,ve)?a(ie,b[Nt],Je,0):-10:D=Je*(Qn/Le),me!=null?O=Wt(Dt,me)?a(Se,b[Dt],En,0):-10:O=En*(Vn/je),R.ori==1){let fi=D;D=O,O=fi}}vt&&(T==null||T.cursor.event.type==Md)&&((D<=1||D>=B-1)&&(D=_r(D,B)),(O<=1||O>=Rt-1)&&(O=_r(O,Rt))),pt?(_f=D,xf=O,[Rr,Pr]=dt.move(i,D,O)):(Be=D,Xe=O)}let Bh={width:0,height:0,left:0,top:0};function zh(){qa(Bh,!1)}let wf,Af,Tf,Ef;function Cf(v,T,D,O,W,J,at){Ts=!0,wn=An=Pn._x=Pn._y=!1,kh(v,T,D,O,W,J,at,!0,!1),v!=null&&(ye(wd,Rd,Rf,!1),ko(yg,i,Rr,Pr,B,Rt,null));let{left:pt,top:vt,width:Nt,height:Dt}=ze;wf=pt,Af=vt,Tf=Nt,Ef=Dt}function Rf(v,T,D,O,W,J,at){Ts=Pn._x=Pn._y=!1,kh(v,T,D,O,W,J,at,!1,!0);let{left:pt,top:vt,width:Nt,height:Dt}=ze,Ot=Nt>0||Dt>0,ie=wf!=pt||Af!=vt||Tf!=Nt||Ef!=Dt;if(Ot&&ie&&qa(ze),Pn.setScale&&Ot&&ie){let Se=pt,ve=Nt,me=vt,Zt=Dt;if(R.ori==1&&(Se=vt,ve=Dt,me=pt,Zt=Nt),wn&&Es(M,Fi(Se,M),Fi(Se+ve,M)),An)for(let Wt in b){let Ve=b[Wt];Wt!=M&&Ve.from==null&&Ve.min!=De&&Es(Wt,Fi(me+Zt,Wt),Fi(me,Wt))}zh()}else dt.lock&&(dt._lock=!dt._lock,tr(T,!0,v!=null));v!=null&&(pn(wd,Rd),ko(wd,i,Be,Xe,B,Rt,null))}function ox(v,T,D,O,W,J,at){if(dt._lock)return;Kt(v);let pt=Ts;if(Ts){let vt=!0,Nt=!0,Dt=10,Ot,ie;R.ori==0?(Ot=wn,ie=An):(Ot=An,ie=wn),Ot&&ie&&(vt=Be<=Dt||Be>=B-Dt,Nt=Xe<=Dt||Xe>=Rt-Dt),Ot&&vt&&(Be=Be<Rr?0:B),ie&&Nt&&(Xe=Xe<Pr?0:Rt),tr(null,!0,!0),Ts=!1}Be=-10,Xe=-10,it.fill(null),tr(null,!0,!0),pt&&(Ts=pt)}function Pf(v,T,D,O,W,J,at){dt._lock||(Kt(v),Do(),zh(),v!=null&&ko(Sg,i,Be,Xe,B,Rt,null))}function If(){A.forEach(eT),k(i.width,i.height,!0)}vr(lh,yo,If);let Nr={};Nr.mousedown=Cf,Nr.mousemove=Mf,Nr.mouseup=Rf,Nr.dblclick=Pf,Nr.setSeries=(v,T,D,O)=>{let W=hn.match[2];D=W(i,T,D),D!=-1&&Oi(D,O,!0,!1)},ut&&(ye(yg,m,Cf),ye(Md,m,Mf),ye(vg,m,v=>{Kt(v),Fo(!1)}),ye(bg,m,ox),ye(Sg,m,Pf),Fd.add(i),i.syncRect=Fo);let Ya=i.hooks=n.hooks||{};function Tn(v,T,D){zn?Re.push([v,T,D]):v in Ya&&Ya[v].forEach(O=>{O.call(null,i,T,D)})}(n.plugins||[]).forEach(v=>{for(let T in v.hooks)Ya[T]=(Ya[T]||[]).concat(v.hooks[T])});let Lf=(v,T,D)=>D,hn=fn({key:null,setSeries:!1,filters:{pub:Ng,sub:Ng},scales:[M,x[1]?x[1].scale:null],match:[Dg,Dg,Lf],values:[null,null]},dt.sync);hn.match.length==2&&hn.match.push(Lf),dt.sync=hn;let Nf=hn.key,Vh=P0(Nf);function ko(v,T,D,O,W,J,at){hn.filters.pub(v,T,D,O,W,J,at)&&Vh.pub(v,T,D,O,W,J,at)}Vh.sub(i);function ax(v,T,D,O,W,J,at){hn.filters.sub(v,T,D,O,W,J,at)&&Nr[v](null,T,D,O,W,J,at)}i.pub=ax;function lx(){Vh.unsub(i),Fd.delete(i),Mn.clear(),Ld(lh,yo,If),c.remove(),St?.remove(),Tn("destroy")}i.destroy=lx;function Gh(){Tn("init",n,t),No(t||n.data,!1),G[M]?Dh(M,G[M]):Do(),st=ze.show&&(ze.width>0||ze.height>0),et=mt=!0,k(n.width,n.height)}return x.forEach(Mr),A.forEach(ji),e?e instanceof HTMLElement?(e.appendChild(c),Gh()):e(i,Gh):Gh(),i}sn.assign=fn;sn.fmtNum=Wd;sn.rangeNum=ch;sn.rangeLog=dh;sn.rangeAsinh=Gd;sn.orient=Sr;sn.pxRatio=we;sn.join=$1;sn.fmtDate=$d,sn.tzDate=iA;sn.sync=P0;{sn.addGap=BA,sn.clipGaps=mh;let n=sn.paths={points:O0};n.linear=k0,n.stepped=GA,n.bars=HA,n.spline=XA}var yh=210,nT=64,iT=[.01,.02,.05,.1,.2,.5,1,2,5,10,15,30,45,90,180,360,...pT(3,20)];function Eo(n,t,e,i){let s=t.map(o=>sT(o,e)),r=t.map((o,a)=>{let l=o.sharing?s.filter((c,h)=>t[h].sharing===o.sharing).flat():null;return oT(o,s[a].map(c=>c.values),l,e,i)});n.replaceChildren(...r.map(o=>o.element)),n.classList.add("plots");for(let o of r)o.start();return{charts:r.map(o=>o.chart),dispose:()=>r.forEach(o=>o.dispose())}}function sT(n,t){return n.lines.map(e=>({clip:e.clip,values:e.readings?t[e.clip].line(e.readings,e.part):dn(e.values,Float32Array)}))}function rT(n,t,e){let i=[0,0];for(let{clip:s,values:r}of n){let o=t[s].time;for(let a=0;a<o.length;a++){let l=o[a]-e.origins[s];l<e.start||l>e.end||(r[a]<i[0]&&(i[0]=r[a]),r[a]>i[1]&&(i[1]=r[a]))}}return i}function Qd(n){let[t,...e]=n.lines.map(i=>i.clip);return e.every(i=>i===t)?t??null:null}function oT(n,t,e,i,s){let{element:r,key:o,place:a}=tf(n,n.owner),l=N("div",{className:"cursor"}),c=null,h=null,u=!1,d=[],f=new ResizeObserver(()=>c?.setSize({width:a.clientWidth,height:yh}));function m(){let{word:x}=n,A=n.lines.map((b,C)=>N("li",{},nr(xs(C)),x?b.name.slice(x.length+1):b.name));o.replaceChildren(...x?[N("li",{},x)]:[],...A)}function _(){(s.span!==h||s.stretched!==u)&&(h=s.span,u=s.stretched,c.setData(G0(n,t,i,h),!1),c.setScale("x",{min:h.start,max:h.end})),l.style.transform=`translateX(${c.valToPos(s.time,"x").toFixed(2)}px)`}function p(){h=s.span,u=s.stretched,c=new sn(aT(n,e,i,s,a.clientWidth),G0(n,t,i,h),a),c.setScale("x",{min:h.start,max:h.end}),c.over.append(l),fT(c,s),f.observe(a),c.hooks.setSize=[_];let x=()=>{m(),c.redraw(!1)};d=[s.onChange(_),$s(x)],m()}function g(){for(let x of d)x();f.disconnect(),c.destroy()}return{element:r,start:p,dispose:g,get chart(){return c}}}function tf(n,t=null){let e=t?`${Zi(t)}. ${n.text}`:n.text,i=N("div",{className:"chart",role:"img","aria-label":e}),s=N("ul",{className:"key"}),r=N("h2",{},`${Zi(n.title)} (${n.unit})`);return t&&r.append(N("small",{},t)),{element:N("figure",{},r,s,i,N("figcaption",{},n.text)),key:s,place:i}}function G0(n,t,e,i){let s=n.lines.map((r,o)=>[Float64Array.from(e[r.clip].time,a=>a-i.origins[r.clip]),t[o]]);return Qd(n)!==null?[s[0]?.[0]??[],...s.map(r=>r[1])]:sn.join(s)}function aT(n,t,e,i,s){let r=vh(),o=(a,l,c)=>hT(n,...t?rT(t,e,i.span):[l,c]);return{width:s,height:yh,legend:{show:!1},cursor:{show:!1},padding:[8,10,0,0],scales:{x:{time:!1,auto:!1,distr:100,fwd:i.shareAt,bwd:i.momentAt},y:{range:o}},series:[{},...ef(n.lines)],axes:[{...r,...nf,labelFont:r.font,label:()=>`${i.span.label} (${La(i.span).unit})${i.stretched?", stretched":""}`,filter:(a,l)=>l,splits:(a,l,c,h,u)=>i.stretched?lT(a,i):cT(c,h,u),values:(a,l)=>l.map(c=>c===null?"":H0(c*La(i.span).factor)),space:56},sf(n)],hooks:{drawClear:[a=>uT(a,e,Qd(n),i.span)],draw:[a=>dT(a,e,Qd(n),i.span)]}}}function lT(n,t){let e=Math.max(2,Math.floor(n.bbox.width/devicePixelRatio/nT)),{factor:i}=La(t.span),s=new Set;for(let r=0;r<=e;r++){let o=t.momentAt(r/e),a=[1,2,3,4,5,6].map(c=>Number((i*o).toPrecision(c))/i),l=c=>Math.abs(t.shareAt(c)-r/e)<.2/e;s.add(a.find(l)??a[a.length-1])}return[...s].filter(r=>r>=t.span.start&&r<=t.span.end)}function cT(n,t,e){let i=Math.ceil(n/e-1e-9);return Array.from({length:Math.floor(t/e+1e-9)-i+1},(s,r)=>(i+r)*e)}function ef(n){return n.map((t,e)=>({stroke:()=>xs(e).colour,dash:xs(e).dash,width:1.6,points:{show:!1},spanGaps:!0}))}var nf={size:24,gap:3,labelSize:18,labelGap:0};function vh(){return{stroke:()=>Fe("--muted"),grid:{stroke:()=>Fe("--grid"),width:1},ticks:{stroke:()=>Fe("--grid"),width:1,size:4},font:"12px system-ui, sans-serif"}}function sf(n){return{...vh(),size:(t,e)=>Math.max(48,16+7*Math.max(0,...(e??[]).map(i=>i.length))),gap:3,values:(t,e)=>e.map(i=>i===null?"":H0(i)),...n.unit==="deg"?{incrs:iT,space:26}:{space:30}}}function hT(n,t,e){let[i,s]=[Math.min(0,t??0),Math.max(0,e??0)],r=.06*(s-i||1);return[n.unit==="deg"||i<0?i-r:i,s+2*r]}function H0(n){let t=Math.abs(n)<1e-12?"0":String(Number(n.toPrecision(6)));return t.length>7?yn(n):t.replace("-","−")}function uT(n,t,e,i){if(e===null)return;let{ctx:s,bbox:r}=n;s.save(),s.fillStyle=Fe("--band");for(let o of t[e].stages.filter(a=>a.driven)){let[a,l]=[o.start,o.end].map(h=>n.valToPos(h-i.origins[e],"x",!0)),c=Math.max(a,r.left);s.fillRect(c,r.top,Math.max(0,Math.min(l,r.left+r.width)-c),r.height)}s.restore()}function dT(n,t,e,i){if(e===null)return;let{ctx:s,bbox:r}=n,o=devicePixelRatio;s.save(),s.strokeStyle=Fe("--muted"),s.font=`bold ${12*o}px system-ui, sans-serif`,s.setLineDash([2*o,3*o]);for(let a of t[e].marks){let l=n.valToPos(a.time-i.origins[e],"x",!0);if(l<r.left-1||l>r.left+r.width+1)continue;s.beginPath(),s.moveTo(l,r.top),s.lineTo(l,r.top+r.height),s.stroke();let c=l>r.left+r.width-16*o?-1:1;s.fillStyle=Fe("--page"),s.fillRect(l+(c>0?2:-14)*o,r.top+1*o,12*o,15*o),s.fillStyle=Fe("--ink"),s.textAlign="center",s.fillText(a.letter,l+c*8*o,r.top+13*o)}s.restore()}function fT(n,t){let e=i=>{t.pause(),t.seek(n.posToVal(i.clientX-n.over.getBoundingClientRect().left,"x"))};n.over.addEventListener("pointerdown",i=>{i.button===0&&(n.over.setPointerCapture(i.pointerId),e(i))}),n.over.addEventListener("pointermove",i=>{n.over.hasPointerCapture(i.pointerId)&&e(i)})}function pT(n,t){return Array.from({length:t-n},(e,i)=>[1,2,5].map(s=>s*10**(n+i))).flat()}function bh(n,t){if(matchMedia("(prefers-reduced-motion: reduce)").matches)return;let e=new IntersectionObserver(i=>{i.some(s=>s.isIntersecting)&&(e.disconnect(),t.play())},{threshold:.3});e.observe(n.querySelector(".picture")??n),n.addEventListener("pointerdown",()=>e.disconnect(),{once:!0})}function W0(n){let t=n.clips.map(Ys),e=ys(t,n.spans),i=go(document.getElementById("player"),t,e,n);i.stage&&rf(i.stage.cells,t,e,n.energy);let s=Eo(document.getElementById("plots"),n.plots,t,e);return bh(document.getElementById("player"),e),{clips:t,clock:e,player:i,plots:s}}function rf(n,t,e,i){let s=t.map((r,o)=>{let a=N("span",{className:"state-now"}),l=N("b",{},nr(xs(o)),r.name);return $s(()=>l.replaceChild(nr(xs(o)),l.firstChild)),n[o].append(l,a),a});e.onChange(()=>{for(let[r,o]of t.entries()){let a=e.clipTime(r),c=[e.time+e.span.origins[r]>o.end?"ended":o.stageAt(a).name],[h]=o.readings;h&&c.push(mT(o.valuesAt(h.name,a),h.unit));let u=o.valuesAt(mr,a).reduce((d,f)=>d+f,0);o.tendons&&c.push(`${yn(i.factor*u)} ${i.unit}`),s[r].textContent=c.join(" · ")}})}function mT(n,t){let e=s=>t==="deg"?`${qn(s,0)}°`:`${yn(s)} ${t}`,i=[Math.min(...n),Math.max(...n)].map(e);return i[0]===i[1]?i[0]:i.join(" to ")}var gT=[.1,.2,.5,1,2,5,10,15,30,45,60,90,180],_T=1.35;function Ha(n,t,e=[],i=null,s=null){let r=t.map(o=>xT(o,e[0],i,s));n.replaceChildren(...r.map(o=>o.element)),n.classList.add("plots");for(let o of r)o.start();return r}function xT(n,t,e,i){let[s,r,o]=[n.lines,n.balls,n.marks].map(M=>M.map(yT)),{element:a,key:l,place:c}=tf(n),h=(r.length?r:[s[0]]).map(M=>N("span",{className:"ball"},r.length&&M.name.length<3?M.name:"")),u=r.map(M=>[M.places[0],M.values[0]]),d=Math.round(_T*yh),f=vT(s),m=f,_=null;function p(){let M=s.map((S,P)=>N("li",{},nr(xs(P)),S.name)),y=r.length?"the run now":"moved by the slider";l.replaceChildren(...M,N("li",{},N("span",{className:"ball still"}),y))}function g(){for(let[M,[y,S]]of u.entries()){let[P,I]=[_.valToPos(y,"x"),_.valToPos(S,"y")];h[M].style.transform=`translate(${P.toFixed(2)}px, ${I.toFixed(2)}px)`}}function x(){let[M,y]=Yi(t.time,e.clipTime(0));for(let[S,{places:P,values:I}]of r.entries())u[S]=[of(P,M,y),of(I,M,y)];g()}function A(M){m=M,_.setScale("x",{min:M[0],max:M[1]})}function b(M,y,S){if(m!==f){let{places:R,values:F}=s[0],z=F.filter((q,H)=>R[H]>=m[0]&&R[H]<=m[1]),[U,G]=[Math.min(...z),Math.max(...z)];return[U-.25*(G-U),G+.25*(G-U)]}let P=r.reduce((R,F)=>Math.max(R,F.most),S),I=Math.min(0,y);return[I-.06*(P-I||1),P+.1*(P-I||1)]}function C(){let M=sn.join(s.map(y=>[y.sorted.places,y.sorted.values]));_=new sn(bT({data:n,lines:s,balls:r,marks:o,energyRange:b},c.clientWidth,d),M,c),_.over.append(...h),new ResizeObserver(()=>_.setSize({width:c.clientWidth,height:d})).observe(c),_.hooks.setSize=[g],_.hooks.setScale=[g],p(),$s(()=>{p(),_.redraw(!1)}),n.top&&c.after(wT(f,n.top,A)),r.length?(e.onChange(x),AT(_,r,t,e)):TT(n,s[0],c,(y,S)=>{u[0]=[y,S],g()},i),A(f)}return{element:a,start:C,now:u,get chart(){return _}}}function yT({name:n,places:t,values:e}){let i={name:n,places:dn(t,Float32Array),values:dn(e,Float32Array)},s=Array.from(i.places.keys()).sort((r,o)=>i.places[r]-i.places[o]);return i.most=i.values.reduce((r,o)=>Math.max(r,o),0),i.sorted={places:s.map(r=>i.places[r]),values:s.map(r=>i.values[r])},i}function of(n,t,e){let i=n[Math.min(t+1,n.length-1)];return n[t]+e*(i-n[t])}function vT(n){let t=n.flatMap(s=>[s.sorted.places[0],s.sorted.places.at(-1)]),[e,i]=[Math.min(...t),Math.max(...t)];return[e-.03*(i-e),i+.03*(i-e)]}function bT({data:n,lines:t,balls:e,marks:i,energyRange:s},r,o){let a=vh(),l=sf(n);return{width:r,height:o,legend:{show:!1},cursor:{show:!1},pxAlign:0,padding:[10,12,0,0],scales:{x:{time:!1,auto:!1,dir:n.backwards?-1:1},y:{range:s}},series:[{},...ef(t)],axes:[{...a,...nf,labelFont:a.font,label:`${n.axis} (deg)`,values:l.values,incrs:gT,space:44},l],hooks:{draw:[c=>ST(c,e),c=>MT(c,i)]}}}function ST(n,t){let{ctx:e,bbox:i}=n,s=1.6*devicePixelRatio;e.save(),e.globalAlpha=.55,e.fillStyle=Fe("--accent");for(let{places:r,values:o}of t)for(let a=0;a<r.length;a++){let[l,c]=[n.valToPos(r[a],"x",!0),n.valToPos(o[a],"y",!0)];l>i.left&&l<i.left+i.width&&c>i.top&&c<i.top+i.height&&e.fillRect(l-s/2,c-s/2,s,s)}e.restore()}function MT(n,t){let{ctx:e,bbox:i}=n,s=devicePixelRatio;e.save(),e.beginPath(),e.rect(i.left-6*s,i.top,i.width+12*s,i.height+6*s),e.clip(),e.setLineDash([]),e.font=`${12*s}px system-ui, sans-serif`;for(let{name:r,places:o,values:a}of t){let l=Array.from(o,f=>n.valToPos(f,"x",!0)),c=Array.from(a,f=>n.valToPos(f,"y",!0)),[h,u]=[l[l.length>>1],c[c.length>>1]];if(e.beginPath(),l.length===1)e.arc(h,u,4.5*s,0,2*Math.PI),e.fillStyle=Fe("--page"),e.fill(),e.strokeStyle=Fe("--ink"),e.lineWidth=1.4*s,e.stroke();else{e.globalAlpha=.35;for(let f of l.keys())e.lineTo(l[f],c[f]);e.strokeStyle=Fe("--line-2"),e.lineWidth=7*s,e.stroke(),e.globalAlpha=1}let d=l.length>1?0:h>i.left+i.width/2?-1:1;e.fillStyle=Fe("--ink"),e.textAlign=["right","center","left"][d+1],e.fillText(r,h+12*d*s,u-9*s)}e.restore()}function wT(n,t,e){let i=[["whole curve",n],["barrier close up",t]].map(([s,r],o)=>{let a=N("button",{type:"button","aria-pressed":String(o===0)},s);return a.addEventListener("click",()=>{for(let l of i)l.setAttribute("aria-pressed",String(l===a));e(r)}),a});return N("div",{className:"ranges",role:"group","aria-label":"part of the curve"},...i)}function AT(n,t,e,i){let s=r=>{let o=n.over.getBoundingClientRect(),[a,l]=[r.clientX-o.left,r.clientY-o.top],[c,h]=[0,1/0];for(let{places:u,values:d}of t)for(let f=0;f<u.length;f++){let m=Math.hypot(n.valToPos(u[f],"x")-a,n.valToPos(d[f],"y")-l);m<h&&([c,h]=[f,m])}i.pause(),i.seekClip(0,e.time[c])};n.over.addEventListener("pointerdown",r=>{r.button===0&&(n.over.setPointerCapture(r.pointerId),s(r))}),n.over.addEventListener("pointermove",r=>{n.over.hasPointerCapture(r.pointerId)&&s(r)})}function TT(n,t,e,i,s){let r=t.places.length-1,o=N("input",{type:"range",min:"0",max:String(r),value:"0"});o.setAttribute("aria-label",`${n.axis} along the curve`);let a=N("output",{"aria-live":"off"}),l=()=>{let d=Number(o.value);i(t.places[d],t.values[d]);let[f,m]=[yn(t.places[d]),`${yn(t.values[d])} ${n.unit}`];a.textContent=`${f}°, ${m}`,o.setAttribute("aria-valuetext",`${n.axis} ${f} degrees, energy ${m}`)},c=n.poses&&s?dn(n.poses,Float32Array):null,h=!1;o.addEventListener("input",()=>{l(),h=!0,c&&s.seek(ET(c,t.places[Number(o.value)]))}),c&&s.onChange(()=>{h||(o.value=String(CT(t.places,of(c,Math.floor(s.time),s.time%1))),l()),h=!1});let u=n.drawn?[N("p",{className:"note"},n.drawn)]:[];e.after(N("div",{className:"slide"},o,a),...u),l()}function ET(n,t){let e=n[n.length-1]>=n[0]?1:-1,i=n.findIndex(r=>e*r>=e*t);if(i<=0)return i===0?0:n.length-1;let s=n[i]-n[i-1];return i-1+(s?(t-n[i-1])/s:0)}function CT(n,t){return n.reduce((e,i,s)=>Math.abs(i-t)<Math.abs(n[e]-t)?s:e,0)}function X0(n){let t=new Set,e={start:n.start,end:n.end,origins:[0]},i=n.start,s=0;function r(){s||=requestAnimationFrame(()=>{s=0;for(let o of t)o()})}return{get time(){return i},span:e,clipTime:(o,a=i)=>Math.min(n.end,Math.max(n.start,a)),timeAt:o=>e.start+o*(e.end-e.start),wayAt:o=>(o-e.start)/(e.end-e.start||1),onChange(o){return t.add(o),r(),()=>t.delete(o)},seek(o){i=Math.min(e.end,Math.max(e.start,o)),r()}}}function $0(n){let t=document.getElementById("curves");if(!n.clips)return{curves:Ha(t,n.curves)};let e=n.clips.map(Ys),i=X0(e[0]),s=fg(document.getElementById("player"),e,i,n);return{clips:e,clock:i,player:s,curves:Ha(t,n.curves,[],null,i)}}function Co(n){return n.energy?mo:Om}function q0(n,t){let e=n.at(t).map(s=>Math.round(255*s)),i=.299*e[0]+.587*e[1]+.114*e[2]>118;return{face:`rgb(${e.join(" ")})`,ink:i?"#000":"#fff"}}var RT={"●":"opened","◆":"folded","■":"closed","×":"unfolded","✱":"stuck","↺":"returned","↻":"reclosed","▷":"moving","◁":"opening","≠":"untrusted","✚":"diverged","⊘":"unbuilt","–":"untried","·":"unrun","⊗":"before","◐":"missed","◒":"missed","○":"apart","△":"placed"};function Ss(n){return`what ${RT[n]??"other"}`}var Y0="time by torque",PT=["energy",Y0];function Sh(n,t){let{factors:e,quantities:i,words:s}=n,r=e.map(u=>u.values.length),o=new Map;for(let u of t)o.set(u.point,[...o.get(u.point)??[],u]);function a(u){if(n.sampled)return e.map(()=>u);let d=[];for(let f=r.length-1;f>=0;f--)d[f]=u%r[f],u=Math.floor(u/r[f]);return d}let l=u=>u.reduce((d,f,m)=>d*r[m]+f,0);function c(u){let f=(PT.includes(u.group)?i.filter(x=>x.group===u.group):[u]).flatMap(x=>x.values??[]).filter(x=>x!==null);if(!f.length)return null;let[m,_]=[f.reduce((x,A)=>Math.min(x,A)),f.reduce((x,A)=>Math.max(x,A))],p=x=>_>m?(x-m)/(_-m):.5,g=IT((u.values??[]).filter(x=>x!==null));return{low:m,high:_,colour:x=>q0(Co(u),p(x)),text:x=>Ji(Number(x.toFixed(g)))}}let h=(u,d)=>`${u.name} ${u.texts[d]}${u.unit?` ${u.unit}`:""}`;return{study:n,sizes:r,numbers:i.filter(u=>u.values&&u.group!==Y0),columns:e,shown:()=>!0,nameOf:()=>"",placesOf:a,pointAt:l,scaleOf:c,factorText:h,largestSpan:t.reduce((u,d)=>Math.max(u,d.play.clips[0].span_m),0),runsOf:u=>o.get(u)??[],word:u=>s[u],pointText:u=>a(u).map((d,f)=>h(e[f],d)).join(", "),valueText(u,d){let f=u.values?.[d]??null;return f===null?s[u.reasons[d]].word:`${Ji(f)} ${u.unit}`}}}function IT(n){let t=n.reduce((e,i)=>Math.max(e,Math.abs(i)),0);return Math.min(20,Math.max(0,2-Math.floor(Math.log10(t||1))))}function Ji(n){let t=Number(n.toPrecision(3));return(t!==0&&Math.abs(t)<.001?t.toExponential():String(t)).replaceAll("-","−")}var LT="http://www.w3.org/2000/svg";function Pe(n,t,...e){let i=document.createElementNS(LT,n);for(let[s,r]of Object.entries(t))i.setAttribute(s,r);return i.append(...e),i}function Ro({values:n,log:t},e=[]){let i=[...new Set(n.filter(d=>typeof d=="string"))];if(i.length)return{words:i,share:f=>(i.indexOf(f)+.5)/i.length,ticks:i,value:f=>i[Math.min(i.length-1,Math.max(0,Math.floor(f*i.length)))]};let s=[...n,...e].filter(d=>typeof d=="number"),r=t&&s.every(d=>d>0),[o,a]=r?[Math.log,Math.exp]:[d=>d,d=>d],l=s.reduce((d,f)=>Math.min(d,o(f)),1/0),c=s.reduce((d,f)=>Math.max(d,o(f)),-1/0),h=d=>c>l?(o(d)-l)/(c-l):.5,u=s.length?(r?NT:Z0)(a(l),a(c)):[];return{words:i,share:h,ticks:u,value:d=>a(l+d*(c-l))}}function af(n,t,e,i,s=[]){let r=t.unit?`${t.name} (${t.unit})`:t.name,o=Ro({values:n,log:t.log},s),a=.04*(i-e),l=h=>e+a+o.share(h)*(i-e-2*a),c=o.ticks.map(h=>[l(h),typeof h=="number"?Ji(h):h]);return{label:r,from:e,to:i,ticks:c,at:l,place:h=>n[h]===null?e:l(n[h])}}function Z0(n,t){if(!(t>n))return[n];let e=(t-n)/5,i=10**Math.floor(Math.log10(e)),s=i*([1,2,5].find(o=>o*i>=e)??10),r=[];for(let o=Math.ceil(n/s)*s;o<=t+1e-9*s;o+=s)r.push(Number(o.toPrecision(12)));return r}function NT(n,t){if(!(t>n))return[n];let e=t/n>200?[1]:[1,2,5],i=[];for(let s=Math.floor(Math.log10(n));s<=Math.ceil(Math.log10(t));s++)for(let r of e){let o=Number((r*10**s).toPrecision(12));o>=n*(1-1e-9)&&o<=t*(1+1e-9)&&i.push(o)}return i.length>1?i:Z0(n,t)}function K0(n,t,e){let i=[Pe("path",{class:"axis",d:`M${n.from} ${t.to}V${t.from}H${n.to}`})],s=(r,o)=>i.push(Pe("text",{class:"label",...o},r));for(let[r,o]of n.ticks)s(o,{x:r,y:t.from+18,"text-anchor":"middle"});for(let[r,o]of t.ticks)s(o,{x:n.from-8,y:r,dy:"0.35em","text-anchor":"end"});return s(n.label,{x:(n.from+n.to)/2,y:e-8,"text-anchor":"middle"}),s(t.label,{transform:`translate(14 ${(t.from+t.to)/2}) rotate(-90)`,"text-anchor":"middle"}),i}var Mh=300,J0=30,DT=92,t_=16,UT=5;function e_(n,t,{best:e,best_word:i,front:s},r){let a={axes:[...new Set(t.map(n.indexOf).filter(A=>A>=0))],opened:null,hovered:null,best:e,bestWord:i,front:s},l=N("div",{className:"titles"}),c=N("div",{className:"drawn"}),h=N("div",{className:"board"},l,c),u=N("div",{className:"scroll"},h),d=N("p",{className:"note",role:"status"}),f=N("p",{className:"note under"}," "),m=N("button",{type:"button"},`show all ${n.study.noun}s`);m.addEventListener("click",()=>{n.forget(),c.querySelector("[role=slider]")?.focus()});let _=()=>{kT(n,a,{board:h,titles:l,place:c,width:u.clientWidth}),wh(n,a,c)},g=N("section",{className:"lines"},N("h2",{},`All ${n.study.noun}s at once`),N("p",{className:"note"},"A press on a line opens its run; each axis has two handles, which leave out what lies beyond them."),OT(n,a,_),u,FT(n,a),N("div",{className:"choices"},m,d),f);HT(n,a,c,f,r),n.whenAsked(()=>{wh(n,a,c),n_(n,a,c),j0(n,d,m)}),j0(n,d,m);let x=0;return new ResizeObserver(()=>{u.clientWidth!==x&&(x=u.clientWidth,_())}).observe(u),{element:g,show(A){a.opened=A,wh(n,a,c)}}}function j0(n,t,e){let{points:i,noun:s}=n.study,r=Array.from({length:i},(l,c)=>c).filter(n.shown),o=r.filter(n.good).length,a=n.study.words.find(l=>l.sign==="●")?.word;t.textContent=`${r.length} of ${i} ${s}s lie within what is asked of the axes${a?`; ${a}: ${o}`:""}.`,e.hidden=n.asked.size===0}function OT(n,t,e){let i=n.columns.map((s,r)=>{let o=N("input",{type:"checkbox",checked:t.axes.includes(r)});return o.addEventListener("change",()=>{t.axes=n.columns.map((a,l)=>l).filter(a=>a===r?o.checked:t.axes.includes(a)),o.checked||n.ask(r,0,1),e()}),N("label",{},o,s.name)});return N("details",{},N("summary",{},"Axes"),N("fieldset",{className:"filter"},N("legend",{},"Show an axis of"),...i))}function FT(n,t){let e=(r,o)=>N("li",{},N("span",{className:`line ${r}`,"aria-hidden":"true"}),o),i=n.study.words.find(r=>r.sign==="●"),s=[];return i&&s.push(e("good",i.word)),n.study.words.some(r=>r.sign!=="●")&&s.push(e("behind",i?"the others":`all ${n.study.noun}s`)),t.front.length&&s.push(e("front","none is better in everything")),t.best!==null&&s.push(e("best",t.bestWord)),s.push(e("opened","open")),n.columns.some(r=>r.limits.length)&&s.push(N("li",{},N("span",{className:"bound","aria-hidden":"true"}),"allowed by a limit")),N("ul",{className:"keys-of-lines"},...s)}function kT(n,t,{board:e,titles:i,place:s,width:r}){let o=t.axes.length,a=Math.max(r,o*DT);e.style.width=`${a}px`,i.replaceChildren(...t.axes.map(c=>BT(n.columns[c]))),i.style.gridTemplateColumns=`repeat(${o}, 1fr)`,t.x=c=>(c+.5)*a/o,t.y=c=>Mh-J0-c*(Mh-2*J0);let l=Pe("svg",{width:a,height:Mh,viewBox:`0 0 ${a} ${Mh}`,role:"img","aria-label":`${n.study.points} ${n.study.noun}s as lines over ${o} axes; the table below has them all`});l.append(Pe("g",{class:"layers"}));for(let[c,h]of t.axes.entries())l.append(...zT(n.columns[h],t.x(c),t.y));s.replaceChildren(l),n_(n,t,s)}function BT(n){let t=n.unit?` (${n.unit})`:"",e=n.aim?N("small",{},`${n.aim} is best`):"";return N("div",{},`${n.name}${t}`,e)}function zT({scale:n,limits:t},e,i){let s=[Pe("path",{class:"axis",d:`M${e} ${i(0)}V${i(1)}`})];for(let{kind:r,bound:o}of t){let a=Math.min(1,Math.max(0,n.share(o)));s.push(Pe("path",{class:"bound",d:`M${e} ${i(a)}V${i(r===">="?1:0)}`}))}for(let r of n.ticks){let o=i(n.share(r));s.push(Pe("path",{class:"axis",d:`M${e} ${o}h5`}),Pe("text",{class:"label",x:e+8,y:o,dy:"0.35em"},typeof r=="number"?Ji(r):r))}return s}function n_(n,t,e){let i=e.contains(document.activeElement)?document.activeElement.dataset.handle:null;for(let s of e.querySelectorAll("[role=slider]"))s.remove();for(let[s,r]of t.axes.entries())for(let o of["least","most"]){let a=VT(n,t,e,r,o);a.style.left=`${t.x(s)}px`,e.append(a),a.dataset.handle===i&&a.focus()}}function VT(n,t,e,i,s){let r=n.columns[i],[o,a]=n.asked.get(i)??[0,1],l=s==="least"?o:a,c=r.scale.value(l),h=typeof c=="number"?`${Ji(c)} ${r.unit}`.trim():String(c??""),u=N("div",{role:"slider",className:`handle ${s}`,tabIndex:0,"aria-orientation":"vertical","aria-label":`${s} ${r.name}`,"aria-valuemin":"0","aria-valuemax":"100","aria-valuenow":String(Math.round(100*l)),"aria-valuetext":h,title:`${s} ${r.name}: ${h}`});u.dataset.handle=`${i} ${s}`,u.dataset.keys="own",u.style.top=`${t.y(l)}px`;let d=_=>{let[p,g]=n.asked.get(i)??[0,1];s==="least"?n.ask(i,Math.min(Math.max(_,0),g),g):n.ask(i,p,Math.max(Math.min(_,1),p))},f=r.scale.words.length?1/r.scale.words.length:.02,m={ArrowUp:f,ArrowRight:f,ArrowDown:-f,ArrowLeft:-f,PageUp:5*f,PageDown:-5*f};return u.addEventListener("keydown",_=>{if(!(_.ctrlKey||_.metaKey||_.altKey)){if(_.key in m)d(l+m[_.key]);else if(_.key==="Home")d(0);else if(_.key==="End")d(1);else return;_.preventDefault()}}),u.addEventListener("pointerdown",_=>{_.preventDefault(),u.focus(),i_(_,p=>d(lf(t,e,p)))}),u}function i_(n,t,e=()=>{}){let i=o=>a=>a.pointerId===n.pointerId&&o(a),s=i(t),r=i(o=>{removeEventListener("pointermove",s),removeEventListener("pointerup",r),removeEventListener("pointercancel",r),e(o)});addEventListener("pointermove",s),addEventListener("pointerup",r),addEventListener("pointercancel",r)}function lf(n,t,e){let i=e.clientY-t.getBoundingClientRect().top;return Math.min(1,Math.max(0,(n.y(0)-i)/(n.y(0)-n.y(1))))}function GT(n,t,e){let i="",s=!1;for(let[r,o]of t.axes.entries()){let a=n.columns[o].values[e];a!==null&&(i+=`${s?"L":"M"}${t.x(r).toFixed(1)} ${t.y(n.columns[o].scale.share(a)).toFixed(1)}`),s=a!==null}return i}function wh(n,t,e){let i=e.querySelector(".layers");if(!i)return;let s=Array.from({length:n.study.points},(h,u)=>u),[r,o]=[s.filter(n.shown),s.filter(h=>!n.shown(h))],a=h=>h===null?[]:[h],l={out:o,behind:r.filter(h=>!n.good(h)),good:r.filter(n.good),front:t.front.filter(n.shown),best:a(t.best),opened:a(t.opened),hovered:a(t.hovered)},c=Object.entries(l).filter(([,h])=>h.length);i.replaceChildren(...c.map(([h,u])=>Pe("path",{class:`line ${h}`,d:u.map(d=>GT(n,t,d)).join("")})))}function HT(n,t,e,i,s){let r=o=>{o!==t.hovered&&(t.hovered=o,e.classList.toggle("pressable",o!==null),i.textContent=o===null?" ":`${n.nameOf(o)}${n.pointText(o)}: ${n.study.statuses[o]}`,wh(n,t,e))};e.addEventListener("pointermove",o=>{o.pointerType==="mouse"&&o.buttons===0&&r(Q0(n,t,e,o))}),e.addEventListener("pointerleave",()=>r(null)),e.addEventListener("pointerdown",o=>{if(o.button!==0||o.target.closest("[role=slider]"))return;let a=o.pointerType==="touch"?null:WT(t,e,o),l=lf(t,e,o),c=!1;i_(o,u=>{c||=Math.hypot(u.clientX-o.clientX,u.clientY-o.clientY)>UT;let d=lf(t,e,u);c&&a!==null&&n.ask(a,Math.min(l,d),Math.max(l,d))},u=>{let d=c||u.type==="pointercancel"?null:Q0(n,t,e,u);d!==null&&s(d)})})}function WT(n,t,e){let i=e.clientX-t.getBoundingClientRect().left,s=n.axes.findIndex((r,o)=>Math.abs(n.x(o)-i)<t_);return s<0?null:n.axes[s]}function Q0(n,t,e,i){let s=e.getBoundingClientRect(),[r,o]=[i.clientX-s.left,i.clientY-s.top],a=t.axes.findLastIndex((m,_)=>t.x(_)<=r),[l,c]=[Math.max(0,a),Math.min(t.axes.length-1,a+1)],h=c>l?(r-t.x(l))/(t.x(c)-t.x(l)):0,u=(m,_)=>{let p=n.columns[t.axes[m]],g=p.values[_];return g===null?NaN:t.y(p.scale.share(g))},[d,f]=[null,t_];for(let m=0;m<n.study.points;m++){if(!n.shown(m))continue;let[_,p]=[u(l,m),u(c,m)],g=_+h*(p-_),x=c>l?(p-_)/(t.x(c)-t.x(l)):0,A=Math.abs(o-g)/Math.hypot(1,x)-(n.good(m)?1:0);A<f&&([d,f]=[m,A])}return d}var XT="●";function s_(n,t){let e=Sh(n,t),i=n.factors.map(c=>({...c,limits:[],aim:""})),s=e.numbers.map(c=>({...c,key:c.name,name:c.title,log:!1,own:null})),r=[...i,...s].map(c=>({...c,scale:Ro(c,$T(c))})),o=new Map,a=[],l=([c,[h,u]],d)=>{let f=r[c].values[d];if(f===null)return!1;let m=r[c].scale.share(f);return m>=h-1e-9&&m<=u+1e-9};return{...e,columns:r,asked:o,indexOf:c=>r.findIndex(h=>h.key===c),shown:c=>[...o].every(h=>l(h,c)),good:c=>e.word(n.verdicts[c]).sign===XT,nameOf:c=>`${n.noun} ${c+1}: `,whenAsked:c=>a.push(c),ask(c,h,u){h<=0&&u>=1?o.delete(c):o.set(c,[h,u]);for(let d of a)d()},forget(){o.clear();for(let c of a)c()}}}function $T({limits:n,values:t}){let e=t.filter(r=>typeof r=="number"),[i,s]=[Math.min(...e),Math.max(...e)];return n.map(r=>r.bound).filter(r=>r>=i-(s-i)&&r<=s+(s-i))}var qT=12,[cf,Ms]=[200,76],Wa=130;function o_(n,{marginals:t,pairs:e},i){let s=N("div",{className:"marginals"}),r=N("div",{className:"pairs"}),[o,a]=[t,e].map(u=>u.map(n.indexOf).filter(d=>d>=0)),l=()=>{s.replaceChildren(...o.map(u=>KT(n,u))),r.replaceChildren(...JT(n,a,i))};r.style.setProperty("--columns",Math.max(1,a.length-1)),n.whenAsked(l),l();let h=[N("h2",{},"Unknown by unknown"),N("p",{className:"note"},"Blue: the samples that agree; grey: all that were drawn. Each is scaled by its own number; those first of which what agrees is spread least like all."),s];return a.length>1&&h.push(N("h2",{},"Pair by pair"),N("p",{className:"note"},"A press shows a pair large."),r),{element:N("section",{className:"agreeing"},...h)}}var YT=n=>Array.from({length:n.study.points},(t,e)=>e),a_=n=>YT(n).filter(t=>!["△","⊘"].includes(n.word(n.study.verdicts[t]).sign));function ZT(n,t,e){let i=t.words.length||qT,s=new Array(i).fill(0);for(let r of e)s[Math.min(i-1,Math.floor(t.share(n.values[r])*i))]+=1/e.length;return s}function KT(n,t){let e=n.columns[t],i=Ro(e),s=a_(n),r=s.filter(p=>n.good(p)&&n.shown(p)),[o,a]=[s,r].map(p=>ZT(e,i,p)),l=Math.max(...o,...r.length?a:[0]),c=cf/o.length,h=(p,g)=>Pe("path",{class:g,d:p.map((x,A)=>`M${A*c+1} ${Ms}v${-x/l*(Ms-4)}h${c-2}V${Ms}z`).join("")}),u=p=>Pe("path",{class:"agree",d:`M0 ${Ms}${p.map((g,x)=>`V${Ms-g/l*(Ms-4)}H${(x+1)*c}`).join("")}V${Ms}`}),d=`${e.name}: ${r_(e,i,r)}`,f=Pe("svg",{viewBox:`0 0 ${cf} ${Ms}`,role:"img","aria-label":d,preserveAspectRatio:"none"},h(o,"all"),...r.length?[u(a)]:[],Pe("path",{class:"axis",d:`M0 ${Ms}H${cf}`})),m=i.words.length?i.words:[0,1].map(p=>Ji(i.value(p))),_=e.unit?` (${e.unit})`:"";return N("figure",{},N("figcaption",{},`${e.name}${_}`),f,N("div",{className:"ends"},...m.map(p=>N("span",{},p))),N("small",{},r_(e,i,r)))}function r_(n,t,e){if(!e.length)return"nothing agrees";if(t.words.length)return t.words.map(r=>`${Math.round(100*e.filter(o=>n.values[o]===r).length/e.length)} % ${r}`).join(", ");let i=e.map(r=>n.values[r]).sort((r,o)=>r-o),s=r=>Ji(i[Math.round(r*(i.length-1))]);return`half of it: ${s(.25)} to ${s(.75)}`}function JT(n,t,e){return t.slice(1).flatMap((i,s)=>t.slice(0,-1).map((r,o)=>o>s?N("span",{}):jT(n,r,i,e)))}function jT(n,t,e,i){let[s,r]=[t,e].map(f=>n.columns[f]),[o,a]=[s,r].map(f=>Ro(f)),l=(f,m)=>Pe("path",{class:m,d:f.map(_=>`M${(4+o.share(s.values[_])*(Wa-8)).toFixed(1)} ${(Wa-4-a.share(r.values[_])*(Wa-8)).toFixed(1)}h0`).join("")}),c=a_(n),h=c.filter(f=>n.good(f)&&n.shown(f)),u=Pe("svg",{viewBox:`0 0 ${Wa} ${Wa}`,"aria-hidden":"true"},l(c.filter(f=>!h.includes(f)),"all"),l(h,"agree")),d=N("button",{type:"button","aria-label":`${r.name} over ${s.name}, large`},u,N("small",{},`${r.name} ↑, ${s.name} →`));return d.addEventListener("click",()=>i(t,e)),d}var[l_,hf]=[600,420],Ah={left:64,right:14,top:12,bottom:52},c_=60,h_={ArrowLeft:-1,ArrowUp:-1,ArrowRight:1,ArrowDown:1};function Th(n,t,e){let{columns:i,study:s}=n,{quantity:r}=t,o=Array.from({length:s.points},(g,x)=>x),a=n.scaleOf(r),l=af(i[t.x].values,i[t.x],Ah.left,l_-Ah.right,t.cells?.across),c=t.y===null?r.values??o.map(()=>0):i[t.y].values,h=t.y===null?{name:r.title,unit:r.unit}:i[t.y],u=af(c,h,hf-Ah.bottom,Ah.top,t.cells?.upwards),d=`${r.title} of ${s.points} ${s.noun}s; arrows move between them, enter opens one`,f=Pe("svg",{viewBox:`0 0 ${l_} ${hf}`,class:["scatter",o.length>c_&&"many",t.ordered&&"judged"].filter(Boolean).join(" "),role:"listbox","aria-label":d});t.cells&&f.append(...eE(t.cells,l,u)),f.append(...K0(l,u,hf),...d_(i[t.x],l,u,!0),...t.y===null?[]:d_(i[t.y],u,l,!1));let m=o.map(g=>[l.place(g),u.place(g)]);t.joined&&f.append(nE(t.front,m,i[t.x].aim));let _=o.length>c_?6:8,p=o.map(g=>tE(n,t,a,g,m[g],_));return f.append(...(t.ordered?QT(n,t,o):o).map(g=>p[g])),(p[t.current??0]??p[0])?.setAttribute("tabindex","0"),iE(f,p,t.ordered?[...o].sort((g,x)=>m[g][0]-m[x][0]):o,e),{element:N("div",{className:"scroll"},f),points:o}}function QT(n,t,e){let i=s=>(n.shown(s)?0:1e6)+(t.best===s?-1:n.study.verdicts[s]);return[...e].sort((s,r)=>i(r)-i(s))}function tE(n,t,e,i,[s,r],o){let{quantity:a}=t,l=a.values?.[i]??null,c=`${n.nameOf(i)}${n.pointText(i)}: ${n.valueText(a,i)}`,h=Pe("g",{role:"option",tabindex:"-1","aria-label":c,"aria-selected":String(t.opened===i),"data-point":i,transform:`translate(${s.toFixed(1)} ${r.toFixed(1)})`},Pe("title",{},c)),u=l===null?n.word(a.reasons[i]).sign:"";return u&&h.setAttribute("class",Ss(u)),n.shown(i)||h.classList.add("out"),t.front?.includes(i)&&h.append(Pe("circle",{r:o+3,class:"front"})),h.append(Pe("circle",{r:o,class:l===null?"missing":"found",fill:l===null?"transparent":e.colour(l).face})),u&&h.append(Pe("text",{"text-anchor":"middle",dy:"0.36em"},u)),t.best===i&&h.append(Pe("text",{class:"best","text-anchor":"middle",dy:-o-6},t.bestWord)),h}function eE(n,t,e){let[i,s]=[u_(n.across.map(t.at)),u_(n.upwards.map(e.at))];return n.works.flatMap((r,o)=>r.map((a,l)=>Pe("rect",{class:a?"map-works":"map-fails",x:i[o],width:i[o+1]-i[o],y:s[l+1],height:s[l]-s[l+1]})))}function u_(n){let t=n.slice(1).map((s,r)=>(s+n[r])/2),[e,i]=[n[0],n.at(-1)];return[e,...t,i]}function d_(n,t,e,i){let s=(a,l)=>Pe("path",{class:l,d:i?`M${a} ${e.from}V${e.to}`:`M${e.from} ${a}H${e.to}`}),r=a=>a>=Math.min(t.from,t.to)&&a<=Math.max(t.from,t.to),o=[];typeof n.own=="number"&&r(t.at(n.own))&&o.push(s(t.at(n.own),"own"));for(let{kind:a,bound:l}of n.limits??[]){let c=t.at(l);if(!r(c))continue;let h=a===">="?t.from:t.to,[u,d]=[Math.min(c,h),Math.abs(c-h)],f=i?{x:u,width:d,y:e.to,height:e.from-e.to}:{y:u,height:d,x:e.from,width:e.to-e.from};o.push(Pe("rect",{class:"beyond",...f}),s(c,"limit"))}return o}function nE(n,t,e){let i=n.map(r=>t[r]).sort((r,o)=>r[0]-o[0]),s=([r,o])=>e==="least"?`H${r.toFixed(1)}V${o.toFixed(1)}`:`V${o.toFixed(1)}H${r.toFixed(1)}`;return Pe("path",{class:"front",d:i.map((r,o)=>o?s(r):`M${r.join(" ")}`).join("")})}function iE(n,t,e,i){let s=r=>r.target.closest("[data-point]");n.addEventListener("click",r=>{s(r)&&i(Number(s(r).dataset.point))}),n.addEventListener("focusin",r=>{for(let o of t)o.setAttribute("tabindex",o===r.target?"0":"-1")}),n.addEventListener("keydown",r=>{let o=s(r);if(!o||r.ctrlKey||r.metaKey||r.altKey)return;let a=Number(o.dataset.point);if(r.key==="Enter"||r.key===" ")i(a);else if(r.key in h_)t[e[e.indexOf(a)+h_[r.key]]]?.focus();else return;r.preventDefault()})}function f_(n,{plane:t,front:e,best:i,best_word:s,joined:r},o){let{quantities:a}=n.study,[l,c]=[t.x,t.y].map(n.indexOf),[h,u]=[l,c],d={quantity:a[0],x:l,y:c,current:i??0,opened:null,front:e,best:i,bestWord:s,ordered:!0},f=N("div",{className:"map-place"}),m=N("div",{className:"map-legend"}),_=()=>{let S=d.x===h&&d.y===u;d.cells=S?t.cells:void 0,d.joined=r&&new Set([d.x,d.y,h,u]).size===2;let P=Th(n,d,p);f.replaceChildren(P.element),m.replaceChildren(...sE(n,d))},p=S=>{g(S),o(S)};function g(S){d.current=d.opened=S;let P=f.contains(document.activeElement);_(),P&&f.querySelector(`[data-point="${S}"]`)?.focus()}let x=n.columns.map((S,P)=>[P,S.name]),A={across:b("across",x,()=>d.x,S=>M("x","y",S)),upwards:b("upwards",x,()=>d.y,S=>M("y","x",S)),show:b("show",a.map((S,P)=>[P,S.title]),()=>a.indexOf(d.quantity),S=>{d.quantity=a[S]})};function b(S,P,I,R){let F=N("select",{},...P.map(([U,G])=>N("option",{value:String(U)},G)));F.value=String(I()),F.addEventListener("change",()=>{R(Number(F.value)),C(),_()});let z=N("label",{},`${S} `,F);return z.dataset.name=S,{element:z,fill:()=>{F.value=String(I())}}}let C=()=>Object.values(A).forEach(S=>S.fill());function M(S,P,I){d[P]===I&&(d[P]=d[S]),d[S]=I}let y=N("section",{className:"map"},N("h2",{},t.title),N("div",{className:"choices"},...Object.values(A).map(S=>S.element)),f,m);return n.whenAsked(_),_(),{element:y,show:g,over(S,P){[d.x,d.y]=[S,P],C(),_()}}}function sE(n,{quantity:t,front:e,cells:i,x:s,y:r}){let o=[],a=n.scaleOf(t);if(a){let u=N("span",{className:"bar","aria-hidden":"true"});u.style.background=Co(t).gradient,o.push(N("p",{className:"scale"},`${t.title} (${t.unit})`,N("span",{},a.text(a.low)),u,N("span",{},a.text(a.high))))}let l=t.values?t.reasons:n.study.verdicts,c=n.study.words.flatMap(({word:u,sign:d},f)=>{let m=l.filter((_,p)=>_===f&&n.shown(p)).length;return m?[N("li",{},N("span",{className:Ss(d),"aria-hidden":"true"},N("span",{},d)),`${u} (${m})`)]:[]});e.length&&c.push(N("li",{},N("span",{className:"ring","aria-hidden":"true"}),"none is better in everything"));let h=[s,r].map(u=>n.columns[u]);if(h.some(u=>typeof u.own=="number")&&c.push(N("li",{},N("span",{className:"dashes","aria-hidden":"true"}),"as designed")),h.some(u=>u.limits.length)&&c.push(N("li",{},N("span",{className:"shade","aria-hidden":"true"}),"beyond a limit")),i)for(let u of["works","fails"])c.push(N("li",{},N("span",{className:`map-${u}`,"aria-hidden":"true"}),`${u} with only these two off`));return c.length&&o.push(N("ul",{},...c)),o}var rE=2e4,oE=16,aE=16,p_={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function __(n,t){let{quantities:e,sampled:i}=n.study,s=n.study.axes.filter(_=>n.sizes[_]>1),[r,o]=s.length>1?s:[null,s[0]??0],a={quantity:e[0],x:o,y:r,fixed:[...n.study.cuts],current:null,opened:null},l=N("div",{className:"map-place"}),c=N("div",{className:"map-legend"}),h=N("p",{className:"note"}),u=()=>{let _=i?Th(n,a,d):hE(n,a,d);l.replaceChildren(_.element),c.replaceChildren(...fE(n,a.quantity,_.points)),h.textContent=pE(n,a.quantity,_.points)},d=_=>{a.current=a.opened=_,lE(l,_),t(_,a.quantity)},f=cE(n,a,s,u),m=N("section",{className:"map"},N("h2",{},"Map"),f.element,l,c,h);return u(),{element:m,show(_){a.current=a.opened=_,i||(a.fixed=n.placesOf(_)),f.fill(),u()}}}function lE(n,t){for(let e of n.querySelectorAll("[data-point]")){let i=Number(e.dataset.point)===t;e.setAttribute("aria-selected",String(i)),e.tabIndex=i?0:-1}}function cE(n,t,e,i){let{factors:s,quantities:r,sampled:o}=n.study,a=N("div",{className:"choices"}),l=(u,d,f,m)=>{let _=N("select",{},...d.map(([p,g])=>N("option",{value:String(p)},g)));return _.value=String(f),_.addEventListener("change",()=>{m(Number(_.value)),h(),i(),[...a.querySelectorAll("label")].find(p=>p.dataset.name===u)?.querySelector("select").focus()}),N("label",{},`${u} `,_)},c=(u,d)=>f=>{t[d]===f&&(t[d]=t[u]),t[u]=f};function h(){let u=[l("show",r.map((d,f)=>[f,d.title]),r.indexOf(t.quantity),d=>{t.quantity=r[d]})];if(e.length>2){let d=e.map(f=>[f,s[f].name]);u.push(l("across",d,t.x,c("x","y")),l("upwards",d,t.y,c("y","x")))}for(let d of e.filter(f=>!o&&f!==t.x&&f!==t.y)){let f=s[d].texts.map((m,_)=>[_,s[d].unit?`${m} ${s[d].unit}`:m]);u.push(l(s[d].name,f,t.fixed[d],m=>{t.fixed[d]=m}))}for(let d of u)d.dataset.name=d.firstChild.textContent.trim();a.replaceChildren(...u)}return h(),{element:a,fill:h}}function hE(n,t,e){let{factors:i}=n.study,[s,r]=[n.sizes[t.x],t.y===null?1:n.sizes[t.y]];if(s*r>rE)return{element:N("p",{className:"note"},"This map has too many cells for a page; the study's figures have it."),points:[]};let o=n.scaleOf(t.quantity),a=s<=oE,l=(g,x)=>n.pointAt(t.fixed.map((A,b)=>b===t.x?g:b===t.y?x:A)),c=new Map,h=[],u=[];for(let g=r-1;g>=0;g--){let x=N("tr",{},N("th",{scope:"row"},t.y===null?"":g_(i[t.y],g)));for(let A=0;A<s;A++){let b=l(A,g),C=N("td",{tabIndex:-1,role:"gridcell"});uE(C,n,t,o,b,a),c.set(`${A} ${g}`,C),u.push(b),x.append(C)}h.push(x)}let d=i[t.x].texts.map((g,x)=>N("th",{scope:"col"},g_(i[t.x],x)));h.push(N("tr",{className:"feet"},N("td"),...d));let f=N("table",{role:"grid",className:a?"grid":"grid small","aria-label":gE(n,t)},N("tbody",{},...h));f.style.setProperty("--columns",s);let m=[...c.values()].find(g=>Number(g.dataset.point)===t.current)??c.get("0 0");m.tabIndex=0,dE(f,c,e);let _=N("div",{className:"upwards"},t.y===null?"":m_(i[t.y])),p=N("div",{className:"across"},m_(i[t.x]));return{element:N("div",{className:r<6?"axes low":"axes"},_,N("div",{},N("div",{className:"scroll"},f),p)),points:u}}function uE(n,t,e,i,s,r){let{quantity:o}=e,a=o.values?.[s]??null;n.dataset.point=s,n.setAttribute("aria-selected",String(e.opened===s));let l=`${t.pointText(s)}: ${o.values?`${o.title} `:""}${t.valueText(o,s)}`;if(n.setAttribute("aria-label",l),n.title=l,a===null){let{sign:u}=t.word(o.reasons[s]);n.className=Ss(u),n.append(N("span",{},r?u:""));return}let{face:c,ink:h}=i.colour(a);n.style.background=c,n.style.color=h,n.textContent=r?i.text(a):""}function dE(n,t,e){let i=new Map([...t].map(([s,r])=>[r,s.split(" ").map(Number)]));n.addEventListener("click",s=>{let r=s.target.closest("[data-point]");r&&e(Number(r.dataset.point))}),n.addEventListener("keydown",s=>{let r=s.target.closest("[data-point]");if(!r||s.ctrlKey||s.metaKey||s.altKey)return;let[o,a]=i.get(r),[l,c]=p_[s.key]??[0,0],h=Math.max(...[...i.values()].map(([d])=>d)),u={Home:`0 ${a}`,End:`${h} ${a}`}[s.key]??`${o+l} ${a+c}`;if(s.key==="Enter"||s.key===" ")e(Number(r.dataset.point));else{if(!(s.key in p_)&&s.key!=="Home"&&s.key!=="End")return;t.has(u)&&(r.tabIndex=-1,t.get(u).tabIndex=0,t.get(u).focus())}s.preventDefault()})}function fE(n,t,e){let i=[],s=n.scaleOf(t);if(s){let o=N("span",{className:"bar","aria-hidden":"true"});o.style.background=Co(t).gradient,i.push(N("p",{className:"scale"},`${t.title} (${t.unit})`,N("span",{},s.text(s.low)),o,N("span",{},s.text(s.high))))}let r=[...x_(t,e)].map(([o,a])=>{let{word:l,sign:c}=n.word(o);return N("li",{},N("span",{className:Ss(c),"aria-hidden":"true"},N("span",{},c)),`${l} (${a})`)});return r.length&&i.push(N("ul",{},...r)),i}function x_(n,t){let e=new Map;for(let i of t){let s=n.reasons[i];s!==null&&e.set(s,(e.get(s)??0)+1)}return new Map([...e].sort(([i],[s])=>i-s))}function pE(n,t,e){let i=e.filter(c=>(t.values?.[c]??null)!==null),s=[...x_(t,e)].map(([c,h])=>`${h} ${n.word(c).word}`),r=`${t.title[0].toUpperCase()}${t.title.slice(1)}`;if(!i.length)return`${r} of ${e.length} points: ${s.join(", ")||"none"}.`;let o=s.length?` The others: ${s.join(", ")}.`:"",[a,l]=[Math.min,Math.max].map(c=>mE(n,t,i,c));return`${r}, known of ${i.length} of ${e.length} points: from ${a} to ${l}.${o}`}function mE(n,t,e,i){let s=e.map(a=>t.values[a]).reduce((a,l)=>i(a,l)),r=e.filter(a=>t.values[a]===s),o=r.length>1?`${r.length} points`:n.pointText(r[0]);return`${n.valueText(t,r[0])} (${o})`}function gE(n,t){let{factors:e}=n.study,i=t.y===null?e[t.x].name:`${e[t.x].name} across and ${e[t.y].name} upwards`;return`${t.quantity.title} over ${i}; arrows move between cells, enter opens one`}function m_(n){return n.unit?`${n.name} (${n.unit})`:n.name}function g_(n,t){let e=Math.ceil(n.texts.length/aE);return t%e?"":n.texts[t]}var _E={deg:.05};function Eh(n,t,e,i,s=0,r=!1){let{heading:o,names:a}=t.mesh.parts,l=t.readings.map(_=>({name:_.name,title:_.row,parts:_.parts,text:p=>uf(p,_.unit),ofState:p=>p.readings[_.name]&&xE(p.readings[_.name],_.unit)})),c=_=>yn(i.factor*_);t.tendons&&l.push({name:mr,title:`tendon energy (${i.unit})`,parts:t.mesh.tendonParts,text:c,ofState:_=>_.tendonEnergy_J.map(c)});let h=l.map(()=>a.map(()=>N("td"))),u=N("caption"),d=N("tr",{},o?N("th",{scope:"col"},o):N("td"),...a.map(_=>N("th",{scope:"col"},_))),f=l.map((_,p)=>N("tr",{},N("th",{scope:"row"},_.title),...h[p])),m=N("table",{className:"numbers"},u,N("thead",{},d),N("tbody",{},...f));return n.replaceChildren(N("div",{className:"table"},m)),n.classList.add("readout"),e.onChange(()=>{let _=e.clipTime(s),p=t.markAt(_),g=p?`, ${p.name} (means)`:"",x=r?`${t.name}: `:"",A=o?`every ${o}`:"everything";u.textContent=`${Zi(`${x}${A}`)} at ${Na(e.time,e.span)}${g}`;for(let[b,C]of l.entries()){let M=p&&C.ofState(p)||Array.from(t.valuesAt(C.name,_),C.text);for(let[y,S]of C.parts.entries())h[b][S].textContent=M[y]}})}function uf(n,t){return t==="deg"?qn(n,1):yn(n)}function xE({mean:n,swing:t},e){return n.map((i,s)=>{let r=t[s]>(_E[e]??.005*Math.abs(i));return`${uf(i,e)}${r?` ± ${uf(t[s],e)}`:""}`})}var yE=0;function Ch(n=document){let t=new ResizeObserver(e=>{for(let{target:i}of e)if(i.scrollWidth>i.clientWidth||i.scrollHeight>i.clientHeight)vE(i);else for(let s of["tabindex","role","aria-label","aria-labelledby"])i.removeAttribute(s)});for(let e of n.querySelectorAll(".table"))t.observe(e)}function vE(n){let{caption:t}=n.querySelector("table");if(n.tabIndex=0,n.setAttribute("role","group"),!t){let e=[...n.querySelectorAll("thead th")].map(i=>i.textContent);return n.setAttribute("aria-label",e.join(", ")||"table")}return t.id||=`caption-${++yE}`,n.setAttribute("aria-labelledby",t.id)}function Rh(n){let t=N("h2"),e=N("p",{className:"outcome",role:"status"}),i=N("table",{className:"numbers"}),s=N("section",{className:"facts",id:"point"},t,e,N("div",{className:"table"},i)),r=N("div",{className:"parts",role:"group","aria-label":`runs of this ${n.study.noun}`}),o=N("div"),a=N("section",{className:"run",id:"run","aria-label":"the run that is open"},r,o),l={facts:s,element:a,point:null,playing:null,open:u,show:m},c=null,h=_d();function u(p,{play:g=!1,transition:x=null}={}){l.point=p;let A=n.runsOf(p);t.textContent=Zi(`${n.study.noun} ${p+1}`),e.textContent=`${Zi(n.pointText(p))}: ${n.study.statuses[p]}.`,i.replaceChildren(N("caption",{},"In the table"),N("tbody",{},...AE(n,p))),r.replaceChildren(...A.length>1?A.map(d):A.map(b=>N("b",{},Zi(b.title)))),A.length?m((x===null?null:A.find(b=>b.transition===x))??A[0],{play:g}):(f(),o.replaceChildren(N("p",{className:"note"},TE(n,p))))}function d(p){let g=N("button",{type:"button"},p.title);return g.dataset.part=p.part,g.addEventListener("click",()=>m(p,{play:!0})),g}function f(){l.playing?.dispose(),l.playing=null}function m(p,{play:g=!1}={}){f();for(let S of r.querySelectorAll("button"))S.setAttribute("aria-pressed",String(S.dataset.part===p.part));let x=c&&c!==p?c:null,A=x?[x,p]:[p],b={player:N("div"),plots:N("div"),readouts:A.map(()=>N("div"))},[C,M]=[EE,CE].map(S=>A.map((P,I)=>S(P,y_(A,n)[I]))),y=p.advice?[N("p",{className:"note"},p.advice)]:[];o.replaceChildren(N("p",{},p.text),_(p),...y,b.player,b.plots,...b.readouts,...C,...M),h.scale=n.largestSpan/p.play.clips[0].span_m,l.playing={run:p,beside:x,...bE(b,p,x,n,h)},Ch(o),g&&!matchMedia("(prefers-reduced-motion: reduce)").matches&&l.playing.clock.play()}function _(p){let x=N("button",{type:"button",className:"pin"},c?`unpin ${n.study.noun} ${c.point+1}`:"pin, to compare it with another");return x.addEventListener("click",()=>{c=c?null:p,m(p),o.querySelector(".pin").focus()}),x}return l}function bE(n,t,e,i,s){let r=e?[e,t]:[t],o=r.map((f,m)=>ME(f,y_(r,i)[m],i)),a=r.map((f,m)=>({...Ys(f.play.clips[0]),...e?{name:o[m]}:{}})),l=ys(a,e?[wE(a)]:t.play.spans),c=r.map(f=>f.play.energy).reduce((f,m)=>m.largest_J>f.largest_J?m:f),h=e?`${Zi(a[0].name)} and ${a[1].name}, side by side on one clock.`:t.play.text,u=go(n.player,a,l,{...t.play,energy:c,text:h},s);e&&u.stage&&rf(u.stage.cells,a,l,c);let d=Eo(n.plots,e?SE(r,a):t.play.plots,a,l);n.plots.classList.toggle("paired",e!==null);for(let[f,m]of a.entries())Eh(n.readouts[f],m,l,c,f,e!==null);return{clips:a,clock:l,player:u,plots:d,dispose(){u.dispose(),d.dispose()}}}function SE(n,t){let e=n.map(({play:s},r)=>s.plots.map(o=>({...o,owner:t[r].name,sharing:`${o.title} ${o.unit}`,lines:o.lines.map(a=>({...a,clip:r}))})));return[...new Set(e.flat().map(s=>s.title))].flatMap(s=>e.flat().filter(r=>r.title===s))}function y_(n,{study:t}){if(n.length===1)return[""];let e=new Set(n.map(i=>i.point)).size<n.length;return n.map(i=>`${t.noun} ${i.point+1}${e?`, ${i.title}`:""}`)}function ME(n,t,e){let{factors:i}=e.study,s=e.placesOf(n.point).map((r,o)=>`${i[o].texts[r]} ${i[o].unit}`.trim());return`${t}: ${s.join(", ")}`}function wE(n){let t=n.map(s=>s.stages.find(r=>r.driven)?.start??s.start),[e,i]=[Math.min(...n.map((s,r)=>s.start-t[r])),Math.max(...n.map((s,r)=>s.end-t[r]))];return{name:"whole runs",label:"time since the first drive acts",start:e,end:i,origins:t,whole:!0}}function AE(n,t){return n.numbers.map(e=>N("tr",{},N("th",{scope:"row"},e.title),N("td",{},n.valueText(e,t))))}function TE(n,t){return n.study.built[t]?`This run was not kept, so it cannot be played here. ${n.study.keeps}`:`There is nothing to play: this ${n.study.noun} cannot be built.`}function EE(n,t){let e=N("div");return e.innerHTML=n.numbers,N("details",{},N("summary",{},`States of ${t||"this run"}`),e)}function CE(n,t){let e=[`forficula run ${n.folder}/design.toml`,`forficula film ${n.folder} --out film.mp4`];return N("details",{},N("summary",{},t?`Commands for ${t}`:"Commands"),N("p",{className:"note"},"In the folder of this page, these run it again, and film it:"),N("pre",{},N("code",{},e.join(`
`))))}function Ph(n,t,e,i){let s=n?.querySelector("table");if(!s)return()=>{};let r=[...s.tBodies[0].rows],o=N("p",{className:"note",role:"status"}),a=RE(t,()=>{let h=a.shown(),u=0;for(let[d,f]of r.entries())f.hidden=!h.has(t.study.verdicts[d])||!t.shown(d),u+=f.hidden?0:1;o.textContent=`${u} of ${r.length} ${t.study.noun}s shown.`});for(let[h,u]of r.entries()){let d=N("button",{type:"button","aria-label":`open ${t.study.noun} ${h+1}`},u.cells[0].textContent);d.addEventListener("click",()=>i(h)),u.cells[0].replaceChildren(d)}let l=t.study.factors.length+1;for(let h of[s.tHead.rows[0],...r])h.cells[l].classList.add("words");IE(s,r,PE(t));let c=N("div",{className:"choices"},a.element,...e?[NE(e,t.study.file)]:[]);return s.closest(".table").before(c,o),a.changed(),a.changed}function RE(n,t){let e=new Map,i=n.study.words.flatMap(({word:r,sign:o,count:a},l)=>{if(!a)return[];let c=N("input",{type:"checkbox",checked:!0});return c.addEventListener("change",t),e.set(l,c),[N("label",{},c,N("span",{className:Ss(o),"aria-hidden":"true"},N("span",{},o)),`${r} (${a})`)]});return{element:N("fieldset",{className:"filter"},N("legend",{},`Show ${n.study.noun}s that`),...i),changed:t,shown:()=>new Set([...e].filter(([,r])=>r.checked).map(([r])=>r))}}function PE(n){let{study:t}=n,e=t.statuses.map((r,o)=>o),i=t.factors.map((r,o)=>e.map(a=>r.values[n.placesOf(a)[o]])),s=n.numbers.map(r=>r.values);return[e,...i,t.statuses,...s]}function IE(n,t,e){let i=[...n.tHead.rows[0].cells];for(let[s,r]of i.entries()){let o=N("button",{type:"button"},...r.childNodes);r.replaceChildren(o),o.addEventListener("click",()=>{let a=r.getAttribute("aria-sort")==="ascending";for(let c of i)c.removeAttribute("aria-sort");r.setAttribute("aria-sort",a?"descending":"ascending");let l=t.map((c,h)=>h).sort((c,h)=>LE(e[s][c],e[s][h],a?-1:1)||c-h);n.tBodies[0].append(...l.map(c=>t[c]))})}i[0].setAttribute("aria-sort","ascending")}function LE(n,t,e){if(n===null||t===null)return(n===null)-(t===null);let i=typeof n=="number"?n-t:String(n).localeCompare(String(t),"en");return e*i}function NE(n,t){let e=N("button",{type:"button",className:"button"},`Download ${t}`);return e.addEventListener("click",()=>{let i=URL.createObjectURL(new Blob([n],{type:"text/csv;charset=utf-8"}));N("a",{href:i,download:t}).click(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}),e}function v_(n){let t=Sh(n.study,n.runs),e=Rh(t),i=(a,l=null)=>{e.open(a,{play:!0,transition:l}),df(e)},s=__(t,(a,l)=>i(a,l.transition)),r=N("div",{},s.element,e.facts);document.getElementById("explorer").replaceChildren(N("div",{className:"explorer"},r,e.element)),Ph(document.getElementById("points"),t,n.csv,a=>{s.show(a),i(a)});let o=DE(t,n.runs);return e.open(o),s.show(o),{model:t,map:s,panel:e,open:i}}function DE(n,t){let e=n.study.quantities.filter(o=>o.group==="torque"),i=o=>[n.study.verdicts[o],...e.map(a=>a.values[o]??1/0),o],s=(o,a)=>{let l=o.findIndex((c,h)=>c!==a[h]);return l>=0&&o[l]<a[l]};return t.map(o=>o.point).reduce((o,a)=>o===null||s(i(a),i(o))?a:o,null)??0}function df({facts:n,element:t}){let{top:e}=t.getBoundingClientRect();if(e>=0&&e<.5*innerHeight)return;let i=n.getBoundingClientRect().left===t.getBoundingClientRect().left,s=matchMedia("(prefers-reduced-motion: reduce)").matches;(i?n:t).scrollIntoView({behavior:s?"auto":"smooth",block:"start"})}function b_(n){let{views:t}=n,e=s_(n.study,n.runs),i=Rh(e),s=[],r=(p,g)=>{i.open(p,{play:g});for(let x of s)x.show?.(p)},o=p=>{r(p,!0),df(i)},a=e_(e,t.lines,t,o),l=e.columns.filter(p=>p.aim).length===2,c=f_(e,{...t,joined:l},o),h=t.pairs?.length?o_(e,t,u):null;s.push(a,c);function u(p,g){c.over(p,g),c.element.scrollIntoView({block:"start"})}let d=n.runs.length?[[c.element,i.facts],[i.element]]:[[c.element],[i.facts]],f=N("div",{className:"explorer"},...d.map(p=>N("div",{},...p))),m={lines:a.element,pairs:h?.element,plane:f};document.getElementById("explorer").replaceChildren(...t.order.map(p=>m[p]));let _=Ph(document.getElementById("points"),e,n.csv,o);return e.whenAsked(_),n.study.points&&r(UE(e,n),!1),{model:e,panel:i,lines:a,plane:c,open:o}}function UE(n,{runs:t,views:e,study:i}){let{best:s}=e,r=t.map(o=>o.point);return s!==null&&r.includes(s)?s:r.find(o=>n.good(o))??r[0]??s??i.verdicts.findIndex((o,a)=>n.good(a)||a===i.points-1)}async function S_(n){let t=new Blob([dn(n,Uint8Array)]).stream(),e=await new Response(t.pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();function i({kind:s,start:r,shape:o,low:a,step:l}){let c=o.reduce((d,f)=>d*f,1);if(s==="f4")return new Float32Array(e,r,c);if(s==="f8")return new Float64Array(e,r,c);let h=new(s==="u2"?Uint16Array:Uint32Array)(e,r,c),u=OE(h,...o);return a?Float32Array.from(u,(d,f)=>a[f%o[1]]+l[f%o[1]]*d):u}return i}function OE(n,t,e){let i=n.constructor,s=new i(1),r=new i(n.length);for(let o=0;o<e;o++){s[0]=0;for(let a=0;a<t;a++)s[0]+=n[o*t+a],r[a*e+o]=s[0]}return r}var FE="M7 4.5v15l12-7.5z",kE="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",js=180/Math.PI,Ih=1,M_=10,w_=720;function E_(n,t,e,i){let[s,r]=[n.lowest,n.highest].map(m=>m*js),o=GE(n),a=VE(n,s,r,o),l=N("button",{type:"button",className:"play"}),c=N("input",{type:"range",min:s,max:r,step:"any","aria-label":"hinge angle"});c.dataset.keys="own";let h=N("p",{className:"time"}),u=m=>{t.pause(),t.seek(i(Math.min(r,Math.max(s,m))/js))},d=()=>t.playing?t.pause():t.play(),f=a.map(({angle:m,name:_})=>{let p=N("button",{type:"button"},N("b",{},A_(m)),` ${_}`);return p.addEventListener("click",()=>u(m)),p});return c.addEventListener("input",()=>u(Number(c.value))),zE(c,()=>e(t.time)*js,u,d),l.addEventListener("click",d),t.onChange(()=>{let m=e(t.time)*js;c.value=m,h.textContent=`${A_(m,1)}${T_(n,m)}`,c.setAttribute("aria-valuetext",`${qn(m,1)} degrees${T_(n,m)}`);for(let[p,g]of a.entries())f[p].setAttribute("aria-pressed",String(Math.abs(g.angle-m)<.005));let _=t.playing?"pause":"play: fold from stop to stop";l.getAttribute("aria-label")!==_&&l.replaceChildren(Za(t.playing?kE:FE)),l.setAttribute("aria-label",_)}),N("div",{className:"transport"},N("div",{className:"line"},l,BE(c,s,r,o,a)),N("div",{className:"choices"},h,N("div",{className:"states"},...f)))}function BE(n,t,e,i,s){let r=N("div",{className:"bands","aria-hidden":"true"}),o=N("div",{className:"ticks","aria-hidden":"true"}),a=l=>`${100*l/(e-t)}%`;for(let[l,c]of i){let h=N("span",{className:"band"});Object.assign(h.style,{left:a(l-t),width:a(c-l)}),r.append(h)}for(let{angle:l,stop:c}of s){let h=N("span",{className:c?"tick stop":"tick"});h.style.left=a(l-t),o.append(h)}return N("div",{className:"track"},r,n,o)}function zE(n,t,e,i){let s={ArrowLeft:-Ih,ArrowDown:-Ih,ArrowRight:Ih,ArrowUp:Ih},r={PageDown:-M_,PageUp:M_,Home:-1/0,End:1/0};n.addEventListener("keydown",o=>{if(!(o.shiftKey||o.ctrlKey||o.metaKey||o.altKey)){if(o.key===" ")i();else if(o.key in s)e(Math.round(t()+s[o.key]));else if(o.key in r)e(t()+r[o.key]);else return;o.preventDefault()}})}var A_=(n,t=null)=>`${t===null?qn(n,Number.isInteger(Number(n.toFixed(3)))?0:1):qn(n,t)}°`;function VE(n,t,e,i){let s=a=>[...new Set(n.joints.map(l=>Number((l[a]*js).toFixed(6))))],r=[...s("lower").map(a=>({angle:a,name:"stop of the fold",stop:!0})),...i.flatMap(([a,l])=>[a,l].map(c=>({angle:c,name:"all straps slack"}))),...t<0&&e>0?[{angle:0,name:"flat"}]:[],...s("upper").map(a=>({angle:a,name:e>0?"stop of the overbend":"stop, flat",stop:!0}))],o=a=>Math.abs(a-t)<1e-6||Math.abs(a-e)<1e-6;return r.filter(a=>a.stop||a.name==="flat"||!o(a.angle)).sort((a,l)=>a.angle-l.angle)}function GE(n){let t=a=>C_(n,a).every(({longer:l})=>l<0),[e,i]=[n.lowest*js,n.highest*js],s=(a,l)=>{let c=t(a);for(let h=0;h<40;h++){let u=(a+l)/2;t(u)===c?a=u:l=u}return l},r=[];if(!n.straps.length)return r;let o=t(e)?null:e;for(let a=1;a<=w_;a++){let[l,c]=[a-1,a].map(h=>e+(i-e)*h/w_);t(l)!==t(c)&&(o===null?o=s(l,c):(r.push([o,s(l,c)]),o=null))}return o!==null&&r.push([o,i]),r}function C_(n,t){let e=n.turn(n.anglesTogether(t/js));return n.straps.flatMap(i=>n.strapStretches(i,e).map(s=>({longer:s,rest:i.rest})))}function T_(n,t){let e=C_(n,t);if(!e.length)return"";let i=e.filter(({longer:a})=>a<0).length,s=Math.max(...e.map(({longer:a})=>a));if(i===e.length)return`, straps slack by ${qn(-1e3*s,1)} mm or more`;let r=Math.max(...e.map(({longer:a,rest:l})=>a/l)),o=`stretched by up to ${qn(1e3*s,1)} mm (${qn(100*r,1)} %)`;return i?`, ${i} of ${e.length} straps slack, others ${o}`:`, straps ${o}`}function R_(n){let t=N("input",{type:"range",min:0,max:100,step:1,value:0});return t.dataset.keys="own",t.addEventListener("input",()=>n(Number(t.value)/100)),t.setAttribute("aria-valuetext","together"),t.addEventListener("input",()=>{t.setAttribute("aria-valuetext",t.value==="0"?"together":`${t.value} % apart`)}),N("label",{className:"slide"},"take apart ",t)}function P_(n,t,e){let i=n.map((s,r)=>{let o=N("input",{type:"checkbox",checked:!0});o.dataset.keys="own",o.addEventListener("change",()=>e(r,o.checked));let a=N("span",{className:"swatch panel","aria-hidden":"true"});return a.style.background=s.colour,N("label",{},o,a,`${s.name}${t[r]>1?`, ${t[r]}`:""}`)});return N("fieldset",{className:"kinds"},N("legend",{},"show"),...i)}function ff(n,t,e){let i=N("select",{},...t.map((s,r)=>N("option",{value:String(r)},s)));return i.addEventListener("change",()=>e(Number(i.value))),N("label",{},`${n} `,i)}var Lh=28,I_=24;function L_(n,t){return n.ends.map(e=>{let[i,s]=e.map((r,o)=>new X(...r).applyMatrix4(Po(t,n.bodies[o])));return i.distanceTo(s)-n.rest})}var HE=new pe,Po=(n,t)=>t<0?HE:n[t];function pf(n,t,e,i,s){let r=new X(...n.axis).transformDirection(Po(t,n.bodies[0])),o=new X(...n.up).transformDirection(Po(t,n.bodies[0]));return n.ends.map(a=>{let l=a.map((x,A)=>new X(...x).applyMatrix4(Po(t,n.bodies[A])).add(i)),c=l[1].clone().sub(l[0]),h=c.dot(r);c.addScaledVector(r,-h);let u=c.length(),d=u>1e-9?c.divideScalar(u):new X().crossVectors(r,o),f=new X().crossVectors(r,d).multiplyScalar(e),_=n.rest>Math.hypot(u,h)?Math.sqrt(n.rest**2-h**2):u,p=WE(s,_>1e-9?u/_:1);return{points:p.map(([x,A],b)=>l[0].clone().addScaledVector(d,x*_).addScaledVector(f,A*_).addScaledVector(r,h*b/(p.length-1))),wide:r,ends:l}})}function WE({values:n,shape:t},e){let[i,s]=t,r=Math.sqrt(Math.max(0,1-e))*(i-1),o=Math.min(i-2,Math.floor(r)),a=Math.min(1,r-o),l=(d,f,m)=>n[(d*s+f)*2+m],c=(d,f)=>l(o,d,f)+a*(l(o+1,d,f)-l(o,d,f)),h=c(s-1,0),u=h>1e-6?e/h:1;return Array.from({length:s},(d,f)=>[u*c(f,0),c(f,1)])}function N_(n,t,e){let i={triangles:[],edges:[]};for(let{points:s,wide:r,ends:o}of t){let a=r.clone().multiplyScalar(n.width/2),l=s.map((c,h)=>{let d=s[Math.min(h+1,s.length-1)].clone().sub(s[Math.max(h-1,0)]).cross(r).setLength(n.thickness/2);return[[-1,-1],[1,-1],[1,1],[-1,1]].map(([f,m])=>c.clone().addScaledVector(a,f).addScaledVector(d,m))});U_(i,l,[0,1,2,3]);for(let[c,h]of o.entries()){let u=new X(...n.across[c]).transformDirection(Po(e,n.bodies[c]));$E(i,h,u,n.width,n.eye/2,n.peg/2)}}return i}function mf(n,t,e){let i=n.places.map(_=>new X(..._).add(e)),[s,r,o,a]=i,l=Po(t,n.body),[c,h]=[o,a].map(_=>_.clone().sub(e).applyMatrix4(l).add(e)),u=r.clone().sub(s).normalize(),d=h.clone().sub(c).normalize(),f=r.distanceTo(o),m=[s];for(let _=0;_<=I_;_++)m.push(XE(r,u,c,d,f,_/I_));return[...m,h]}function XE(n,t,e,i,s,r){let[o,a]=[1-r,r];return n.clone().multiplyScalar(o*o*(1+2*a)).addScaledVector(e,a*a*(1+2*o)).addScaledVector(t,s*o*o*a).addScaledVector(i,-s*a*a*o)}function D_(n,t){let e={triangles:[],edges:[]},i=n[1].clone().sub(n[0]).normalize(),s=new X(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0),r=n.map((o,a)=>{let l=n[Math.min(a+1,n.length-1)].clone().sub(n[Math.max(a-1,0)]).normalize();s=s.clone().addScaledVector(l,-s.dot(l)).normalize();let c=new X().crossVectors(l,s);return Array.from({length:Lh},(h,u)=>{let d=2*Math.PI*u/Lh;return o.clone().addScaledVector(s,Math.cos(d)*t/2).addScaledVector(c,Math.sin(d)*t/2)})});return U_(e,r,[]),e}function U_({triangles:n,edges:t},e,i){let s=e[0].length;for(let r=1;r<e.length;r++){let[o,a]=[e[r-1],e[r]];for(let l=0;l<s;l++){let c=(l+1)%s;n.push(o[l],o[c],a[c],o[l],a[c],a[l]),i.includes(l)&&t.push(o[l],a[l])}}for(let r of[e[0],e.at(-1)])for(let o=1;o<s-1;o++)n.push(r[0],r[o],r[o+1])}function $E({triangles:n,edges:t},e,i,s,r,o){let a=new X(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0);a.addScaledVector(i,-a.dot(i)).normalize();let l=new X().crossVectors(i,a),c=(h,u,d)=>e.clone().addScaledVector(i,d*s/2).addScaledVector(a,u*Math.cos(h)).addScaledVector(l,u*Math.sin(h));for(let h=0;h<Lh;h++){let[u,d]=[h,h+1].map(m=>2*Math.PI*m/Lh),f=(m,_,p,g)=>n.push(m,_,p,m,p,g);f(c(u,r,-1),c(d,r,-1),c(d,r,1),c(u,r,1));for(let m of[-1,1])f(c(u,o,m),c(d,o,m),c(d,r,m),c(u,r,m)),t.push(c(u,r,m),c(d,r,m))}}function O_(n,t){let e=t.map(({origin:a,axis:l})=>[new X(...a),new X(...l)]),i=n.map((a,l)=>t.flatMap((c,h)=>c.body===l?[h]:[])),s=n.map(()=>new pe),r=new pe,o=new X;return function(l){for(let[c,h]of n.entries()){let u=s[c];h<0?u.identity():u.copy(s[h]);for(let d of i[c]){let[f,m]=e[d];r.makeRotationAxis(m,l[d]-t[d].built),o.copy(f).applyMatrix4(r),r.setPosition(f.x-o.x,f.y-o.y,f.z-o.z),u.multiply(r)}}return s}}var qE=[-1,0,1].flatMap(n=>[-1,0,1].flatMap(t=>[-1,0,1].map(e=>[n,t,e]))),YE=new pe;function F_(n,t){let e=n.parts.map(f=>({...f,...f.mesh?ZE(f.mesh,t):{}})),i={values:t(n.bows),shape:n.bows.shape},s=O_(n.bodies,n.turns),r=Math.min(...n.joints.map(f=>f.lower)),o=Math.max(...n.joints.map(f=>f.upper)),a=new Float64Array(n.turns.length);function l(f){for(let[m,_]of n.turns.entries())a[m]=_.built;for(let m of n.joints)a[m.turn]=Math.min(m.upper,Math.max(m.lower,f));return a}let c=(f,m)=>new X(...f.apart).multiplyScalar(m);function h(f,m,_,p=new pe){let g=c(f,_);return p.copy(f.body===null||f.body<0?YE:m[f.body]).multiply(new pe().makeTranslation(g.x,g.y,g.z))}function u(f,m,{apart:_,side:p}){let g=c(f,_);return f.root?D_(mf(f.root,m,g),f.root.diameter):N_(f.strap,pf(f.strap,m,p,g,i),m)}function d(f,m,{apart:_,side:p}){let g=[];for(let x of f){if(x.outer){let C=h(x,m,_);for(let M of x.outer)g.push(...M.clone().applyMatrix4(C).toArray());continue}let A=c(x,_),b=x.root?[mf(x.root,m,A)]:pf(x.strap,m,p,A,i).map(C=>C.points);for(let C of b)for(let M=0;M<C.length;M+=4)g.push(...C[M].toArray())}return Float64Array.from(g)}return{parts:e,looks:n.looks,joints:n.joints,turns:n.turns,lowest:r,highest:o,turn:s,anglesTogether:l,matrixOf:h,bentMesh:u,outline:d,straps:e.filter(f=>f.strap).map(f=>f.strap),strapStretches:L_}}function ZE({points:n,triangles:t,stops:e,edges:i},s){let r=s(n),o=s(t),a=n.shape[0];for(let l=0;l<o.length;l+=3)o[l+1]=(o[l]+o[l+1])%a,o[l+2]=(o[l]+o[l+2])%a;return{places:r,corners:o,stops:e,edges:s(i),outer:KE(r)}}function KE(n){let t=new Set;for(let[e,i,s]of qE){let[r,o]=[0,-1/0];for(let a=0;a<n.length;a+=3){let l=e*n[a]+i*n[a+1]+s*n[a+2];l>o&&([r,o]=[a,l])}t.add(r)}return Array.from(t,e=>new X().fromArray(n,e))}function k_(n,t){let e=t(n.time),i=t(n.angles),[,s]=n.angles.shape,r=new Float64Array(s);function o(a){let[l,c]=Yi(e,a),h=Math.min(l+1,e.length-1);for(let u=0;u<s;u++){let d=i[l*s+u];r[u]=d+c*(i[h*s+u]-d)}return r}return{time:e,anglesAt:o,marks:n.marks,stages:n.stages,spans:n.spans}}var JE="#14171a",jE=.55,QE=Math.cos(Math.PI/9),tC=.42;function B_(n,t,e,i){let s=n.parts.map(f=>eC(f,n.looks[f.look].colour,i)),r=new On;for(let f of s)r.add(f.mesh,f.lines);let o=new On,a=n.turn(n.anglesTogether(0));function l(f){a=n.turn(e(f));for(let[m,_]of n.parts.entries()){let{mesh:p,lines:g}=s[m],x=!t.hidden.has(_.look);for(let A of[p,g])A.visible=x;x&&(_.places?n.matrixOf(_,a,t.apart,p.matrix):sC(s[m],n.bentMesh(_,a,t)))}}function c(){let f=new Qt(Fe("--accent"));for(let[m,{mesh:_}]of s.entries())for(let p of[_.material].flat())p.emissive.copy(f),p.emissiveIntensity=t.chosen===m?tC:0}function h(f,m){let _=new ga;_.setFromCamera(f,m),r.updateMatrixWorld(!0);for(let{mesh:g}of s)g.geometry.boundingSphere===null&&g.geometry.computeBoundingSphere();let[p]=_.intersectObjects(s.map(g=>g.mesh).filter(g=>g.visible),!1);return p?s.findIndex(g=>g.mesh===p.object):null}function u(f){let m=n.parts.findIndex(x=>x.name===f),{mesh:_}=s[m],p=_.geometry.getAttribute("position"),g=new nn(p.array.slice(),3);return Array.from(g.applyMatrix4(_.matrix).array)}function d(){for(let{mesh:f,lines:m}of s){f.geometry.dispose(),m.geometry.dispose();for(let _ of[f.material,m.material].flat())_.dispose()}}return{group:r,shadow:o,pose:l,paint:c,sort:()=>{},at:h,verticesOf:u,dispose:d,current:()=>a}}function eC(n,t,e){let i=(h,u)=>new ps({color:h,side:Fn,flatShading:u,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),s=n.places?nC(n):new gn,r=n.places?[i(e,!1),i(t,!1)]:i(t,!0),o=new Ln(s,r),a=new gn;n.places&&a.setAttribute("position",new nn(z_(n.places,n.edges),3));let l=new ks({color:JE,transparent:!0,opacity:jE}),c=new lr(a,l);for(let h of[o,c])Object.assign(h,{frustumCulled:!1,matrixAutoUpdate:!1});return c.matrix=o.matrix,{mesh:o,lines:c}}function nC({places:n,corners:t,stops:e}){let i=new gn;return i.setAttribute("position",new nn(z_(n,t),3)),i.setAttribute("normal",new nn(iC(n,t),3)),i.addGroup(0,3*e,0),i.addGroup(3*e,t.length-3*e,1),i}function z_(n,t){let e=new Float32Array(3*t.length);for(let[i,s]of t.entries())for(let r=0;r<3;r++)e[3*i+r]=n[3*s+r];return e}function iC(n,t){let e=t.length/3,i=new Float64Array(t.length),s=Array.from({length:n.length/3},()=>[]);for(let l=0;l<e;l++){let[c,h,u]=[0,1,2].map(f=>3*t[3*l+f]),d=(f,m,_)=>n[m+_%3]-n[f+_%3];for(let f=0;f<3;f++)i[3*l+f]=d(c,h,f+1)*d(c,u,f+2)-d(c,h,f+2)*d(c,u,f+1);for(let f=0;f<3;f++)s[t[3*l+f]].push(l)}let r=Float64Array.from({length:e},(l,c)=>Math.hypot(...i.subarray(3*c,3*c+3))),o=new Float32Array(3*t.length),a=(l,c)=>i[3*l]*i[3*c]+i[3*l+1]*i[3*c+1]+i[3*l+2]*i[3*c+2];for(let l=0;l<t.length;l++){let c=Math.floor(l/3),h=[0,0,0];for(let d of s[t[l]])if(d===c||a(c,d)>=QE*r[c]*r[d])for(let f=0;f<3;f++)h[f]+=i[3*d+f];let u=Math.hypot(...h)||1;for(let d=0;d<3;d++)o[3*l+d]=h[d]/u}return o}function sC({mesh:n,lines:t},{triangles:e,edges:i}){for(let[s,r]of[[n,e],[t,i]]){let{geometry:o}=s,a=o.getAttribute("position");a?.count!==r.length&&(a=new nn(new Float32Array(3*r.length),3),o.setAttribute("position",a));for(let[l,c]of r.entries())c.toArray(a.array,3*l);a.needsUpdate=!0,o.boundingSphere=null}}var rC=.25,V_=60,oC=4;async function H_(n){let t=await S_(n.arrays),e=F_(n,t),i={apart:0,side:1,hidden:new Set,chosen:null},s=[aC(e,i),...n.motion?[lC(e,i,k_(n.motion,t))]:[]],r=cC(s),o=document.getElementById("player"),a=hC(o,n,e,i,r),l=gC(e,n,i,a);return a.onPress(l.choose),{model:e,state:i,clock:s[0].clock,run:s[1]?.clock??null,...a,choose:l.choose}}function aC(n,t){let e=c=>n.highest+c*(n.lowest-n.highest),i=c=>(c-n.highest)/(n.lowest-n.highest||1),s=Float64Array.from({length:V_+1},(c,h)=>h/V_),r=c=>n.anglesTogether(e(c)),o=W_(n,t,{time:s,anglesAt:r,marks:[],stages:[]}),a=ys([X_(n,o,r)],[{name:"",label:"",start:0,end:1,origins:[0],whole:!1}]);a.setSpeed(rC);let l=E_(n,a,e,i);return{name:"all joints alike",clip:o,clock:a,anglesAt:r,control:l}}function lC(n,t,e){let i=W_(n,t,e),s=ys([X_(n,i,e.anglesAt)],e.spans);return{name:"as in the simulated run",clip:i,clock:s,anglesAt:e.anglesAt,control:th([i],s)}}function W_(n,t,{time:e,anglesAt:i,marks:s,stages:r}){let o=()=>{let a=n.parts.filter(l=>!t.hidden.has(l.look));return a.length?a:n.parts};return{name:"",time:e,start:e[0],end:e[e.length-1],marks:s,stages:r,readings:[],reach:0,mesh:{tubes:[],joints:[],jointRadius:0},pointsAt:a=>n.outline(o(),n.turn(i(a)),t),stageAt:a=>r.findLast(l=>l.start<=a)??r[0],markAt:a=>s.find(l=>Math.abs(l.time-a)<1e-9)}}function X_(n,t,e){let i=n.parts.filter(s=>s.outer).map(s=>({...s,outer:[s.outer[0],s.outer.at(-1)]}));return{...t,pointsAt:s=>n.outline(i,n.turn(e(s)),{apart:0,side:1})}}function cC(n){let t=n[0],e={of:null},i=new Set;for(let a of n)a.clock.onChange(()=>{if(a===t)for(let l of i)l()});let s=()=>t.clock.redraw(),r={get time(){return t.clock.time},get playing(){return t.clock.playing},get span(){return e.of!==t.clock.span&&(e={...t.clock.span,of:t.clock.span}),e},clipTime:(a,l)=>t.clock.clipTime(a,l),timeAt:a=>t.clock.timeAt(a),wayAt:a=>t.clock.wayAt(a),onChange(a){return i.add(a),s(),()=>i.delete(a)},seek:a=>t.clock.seek(a),seekClip:(a,l)=>t.clock.seekClip(a,l),step:a=>t.clock.step(a),play:()=>t.clock.play(),pause:()=>t.clock.pause()};return{clip:{...n[0].clip,pointsAt:a=>t.clip.pointsAt(a)},clock:r,sources:n,get now(){return t},anglesAt:a=>t.anglesAt(a),take(a){t.clock.pause(),t=n[a],e={of:null},s()},changed(){e={of:null},s()}}}var $_="Press a part, or its name in the table, to see what it is.",G_="parts";function hC(n,t,e,i,s){let{clip:r,clock:o,sources:a}=s,l=null,h=Ua([r],o,()=>l=B_(e,i,s.anglesAt,t.stopColour),t.text),u=h?N("div",{className:"picture"},h.element,ih(h.eye,null)):N("p",{className:"note"},nh(G_)),d=N("p",{className:"chosen",role:"status"},$_),f=N("div",{},a[0].control);return n.replaceChildren(u,d,f,uC(e,i,s,f),dC(e,i,s),fC(t,e,h),jc([r],h!==null,G_)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label","the parts moving"),Qc(n,[r],o,h?.eye,gr[0]),{stage:h,shape:l,info:d,repaint:()=>{l?.paint(),o.seek(o.time)},onPress:m=>h&&mC(h.canvas,_=>m(l.at(_,h.eye.camera)))}}function uC(n,t,e,i){let s=l=>{Object.assign(t,l),e.changed()},r=e.sources.map(l=>l.name),o=ff("motion",r,l=>{e.take(l),i.replaceChildren(e.now.control)}),a=ff("slack straps bow",["away from the hinge","towards the hinge"],l=>s({side:l?-1:1}));return N("div",{className:"choices"},...r.length>1?[o]:[],R_(l=>s({apart:l})),...n.straps.length?[a]:[])}function dC(n,t,e){let i=n.looks.map((s,r)=>n.parts.reduce((o,a)=>o+(a.look===r?a.count:0),0));return P_(n.looks,i,(s,r)=>{r?t.hidden.delete(s):t.hidden.add(s),e.changed()})}function fC(n,t,e){let i=N("span",{className:"swatch taut","aria-hidden":"true"});return N("ul",{className:"legend"},...t.parts.some(s=>s.stops)?[pC(n.stopColour,"face of a stop")]:[],...t.straps.length?[N("li",{},i,"on the slider: where straps are taut")]:[],...e?[N("li",{},`squares of the grid: ${yn(1e3*Da(e.eye.size))} mm`)]:[])}function pC(n,t){let e=N("span",{className:"swatch panel","aria-hidden":"true"});return e.style.background=n,N("li",{},e,t)}function mC(n,t){let e=null;n.addEventListener("pointerdown",i=>{e=i.isPrimary?[i.clientX,i.clientY]:null}),n.addEventListener("pointerup",i=>{if(e===null||Math.hypot(i.clientX-e[0],i.clientY-e[1])>oC)return;let s=n.getBoundingClientRect(),[r,o]=[(i.clientX-s.left)/s.width,(i.clientY-s.top)/s.height];t(new Yt(2*r-1,1-2*o))})}function gC(n,t,e,i){let r=Array.from(document.querySelectorAll("#bill tbody tr")).map((l,c)=>{let[h]=l.querySelector("th").childNodes,u=N("button",{type:"button",className:"name","aria-pressed":"false"},h.textContent);return h.replaceWith(u),u.addEventListener("click",()=>o(e.chosen===c?null:c)),u});function o(l){e.chosen=l;for(let[c,h]of r.entries())h.setAttribute("aria-pressed",String(c===l));i.info.textContent=l===null?$_:a(l),i.repaint()}function a(l){let c=n.parts[l],[h,u,d]=c.facts,f=c.count>1?`${c.count} alike, each `:"";return`${c.name}: ${n.looks[c.look].name} of ${h}, ${f}${u}, ${d}`}return{choose:o}}function q_(n){let t=n.clips.map(Ys),e=ys(t,n.spans),i=go(document.getElementById("player"),t,e,n),s=n.curves?Ha(document.getElementById("curves"),n.curves,t,e):[],r=Eo(document.getElementById("plots"),n.plots,t,e);return Eh(document.getElementById("readout"),t[0],e,n.energy),bh(document.getElementById("player"),e),{clips:t,clock:e,player:i,curves:s,plots:r}}var _C={run:q_,compare:W0,curves:$0,study:v_,goals:b_,parts:H_},Y_=JSON.parse(document.getElementById("data").textContent);function Z_(n){let t=`What moves cannot be shown in this browser (${n.message}); the numbers below are all there.`;throw document.querySelector("main").prepend(N("p",{className:"note",role:"alert"},t)),n}function K_(n){window.forficula=n}try{let n=_C[Y_.kind](Y_);n instanceof Promise?n.then(K_,Z_):K_(n)}catch(n){Z_(n)}Ch();})();
